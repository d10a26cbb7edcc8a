/* The actions as cards with their posture strips; the occurrences of the chosen one beside them. */
(function () {
  "use strict";
  const parts = (window.motionscapeGrammar = window.motionscapeGrammar || {});
  const { element, clock, plural } = parts;
  const ROWS = 60;

  function card(action) {
    const button = parts.plays(element("button", "action-card"), { action: action.id });
    button.type = "button";
    button.dataset.action = action.id;
    button.style.setProperty("--tone", action.colour);
    button.title = `Play all occurrences of ${action.name}`;
    const head = element("span", "action-head");
    head.append(element("b", "ellipsis", action.name), element("span", "muted number", action.named ? String(action.id) : ""));
    const strip = element("img", "action-strip");
    Object.assign(strip, { src: action.strip, alt: "", loading: "lazy", draggable: false });
    const facts = element("span", "muted number action-facts");
    facts.append(element("span", "", `${plural(action.count, "time")}, ${action.seconds.toFixed(1)} s`));
    if (action.label) facts.append(element("span", "ellipsis action-label", action.label));
    button.append(head, strip, facts);
    return button;
  }

  function occurrence([clip, start, end, number], id, chosen) {
    const button = parts.plays(element("button", "occurrence" + (chosen ? " chosen" : "")), { action: id, segment: number });
    button.type = "button";
    button.title = `Play ${clip.clip}, ${clock(start)} to ${clock(end)}`;
    button.setAttribute("aria-pressed", String(chosen));
    const strip = element("img", "occurrence-strip");
    const frames = new URLSearchParams({ start: Math.round(start * clip.fps), end: Math.round(end * clip.fps), n: 4, v: parts.data.version });
    strip.src = `/api/filmstrip/${encodeURIComponent(parts.data.dataset)}/${encodeURIComponent(clip.clip)}?${frames}`;
    Object.assign(strip, { alt: "", loading: "lazy", draggable: false });
    button.append(parts.icon("play"), element("span", "ellipsis", clip.brief), element("span", "muted number", `${clock(start)} to ${clock(end)}`), strip);
    return button;
  }

  const occurrences = (data, id) =>
    data.rows
      .flatMap((clip) => clip.pieces.filter((piece) => piece[2] === id).map((piece) => [clip, piece[0], piece[1], piece[3]]))
      .sort((a, b) => a[3] - b[3]);

  parts.drawActions = (data, order) => {
    const box = parts.find("action-cards");
    if (!box || !parts.fresh(box, [data.key, data.names, order])) return;
    const sorted = [...data.actions];
    if (order === "count") sorted.sort((a, b) => b.count - a.count);
    if (order === "seconds") sorted.sort((a, b) => b.seconds - a.seconds);
    if (order === "name") sorted.sort((a, b) => b.named - a.named || a.name.localeCompare(b.name, undefined, { numeric: true }));
    parts.redraw(box, sorted.map(card));
  };

  parts.drawOccurrences = (data, selection) => {
    const box = parts.find("occurrences");
    if (!box) return;
    const id = selection?.action === undefined ? null : Number(selection.action);
    const known = id !== null && data.actions?.[id];
    for (const one of document.querySelectorAll(".action-card")) one.classList.toggle("chosen", known && Number(one.dataset.action) === id);
    parts.find("action-hint").classList.toggle("hidden", Boolean(known));
    parts.find("action-detail").classList.toggle("hidden", !known);
    if (!known || !parts.fresh(box, [data.key, data.names, id, selection.segment])) return;
    const all = occurrences(data, id);
    parts.find("action-title").textContent = `Action ${id}`;
    parts.find("action-count").textContent = `${plural(all.length, "time")} in ${plural(known.clips, "recording")}`;
    const shown = all.slice(0, ROWS).map((one) => occurrence(one, id, String(one[3]) === String(selection.segment)));
    parts.redraw(box, shown);
    if (all.length > ROWS) box.append(element("div", "muted selection-more", `and ${all.length - ROWS} more, all of them in the recordings above`));
    parts.plays(parts.find("action-all"), { action: id });
  };
})();
