/* The map as a picture: the heatmap as Plotly draws it, and over it everything that was chosen, in one SVG or PNG. */
(function () {
  "use strict";
  const parts = (window.motionscapeMapParts ||= {});
  const LOOK = ["fill", "fill-opacity", "stroke", "stroke-width", "stroke-opacity", "stroke-dasharray", "font", "text-anchor"];

  /** A copy of what lies over the map, its look written into it: a file knows no style sheets. */
  function copied(source) {
    const copy = source.cloneNode(true);
    const from = [source, ...source.querySelectorAll("*")], to = [copy, ...copy.querySelectorAll("*")];
    from.forEach((node, k) => {
      const style = getComputedStyle(node);
      for (const name of LOOK) if (style.getPropertyValue(name)) to[k].style.setProperty(name, style.getPropertyValue(name));
      to[k].setAttribute("vector-effect", "non-scaling-stroke");
    });
    copy.querySelector(".map-layer-cursor")?.remove();
    return copy;
  }

  async function drawing() {
    const { overlay } = window.motionscapeMap, plot = overlay.plot;
    const { width, height } = plot.getBoundingClientRect();
    const address = await window.Plotly.toImage(plot, { format: "svg", width, height });
    const text = decodeURIComponent(address.slice(address.indexOf(",") + 1));
    const page = new DOMParser().parseFromString(text, "image/svg+xml").documentElement;
    const ground = getComputedStyle(document.documentElement).getPropertyValue("--surface");
    page.prepend(parts.svgElement("rect", { width: "100%", height: "100%", fill: ground.trim() }));
    page.append(copied(overlay.view));
    return { text: new XMLSerializer().serializeToString(page), width, height };
  }

  function save(blob, name) {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(blob);
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10000);
  }

  async function picture({ text, width, height }) {
    const image = new Image();
    image.src = URL.createObjectURL(new Blob([text], { type: "image/svg+xml" }));
    await image.decode();
    const canvas = Object.assign(document.createElement("canvas"), { width: 2 * width, height: 2 * height });
    canvas.getContext("2d").drawImage(image, 0, 0, canvas.width, canvas.height);
    URL.revokeObjectURL(image.src);
    return new Promise((done) => canvas.toBlob(done, "image/png"));
  }

  document.addEventListener("click", async (event) => {
    const button = event.target.closest?.("[data-map-save]");
    if (!button || !window.motionscapeMap.state.map) return;
    const made = await drawing(), name = `${window.motionscapeMap.state.known.dataset} map`;
    if (button.dataset.mapSave === "svg") save(new Blob([made.text], { type: "image/svg+xml" }), `${name}.svg`);
    else save(await picture(made), `${name}.png`);
  });
})();
