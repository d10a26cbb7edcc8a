/* Saving what is on the page: charts as PNG, SVG or CSV, drawings as PNG or SVG, tables as CSV. */
(function () {
  "use strict";

  const dataset = () => {
    const picker = document.getElementById("dataset-picker");
    return (picker && picker.value) || "motionscape";
  };

  function save(content, name, type = "text/csv") {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(new Blob([content], { type }));
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10000);
  }

  const cell = (value) => {
    const text = value === null || value === undefined ? "" : String(value);
    return /[",\n]/.test(text) ? `"${text.replace(/"/g, '""')}"` : text;
  };

  // Plotly may hold numbers as {dtype, bdata}; its calculated copy has plain arrays.
  const plain = (values) => (values && values._inputArray) || values || [];

  /** A row a point: name of the series, x, y and, where there is one, z. */
  function table(chart) {
    const layout = chart._fullLayout;
    const title = (axis, other) => (layout[axis] && layout[axis].title && layout[axis].title.text) || other;
    const rows = [["series", title("xaxis", "x"), title("yaxis", "y"), "value"]];
    for (const trace of chart._fullData) {
      if (trace.visible === false || trace.hoverinfo === "skip") continue;
      const x = plain(trace.x), y = plain(trace.y), z = trace.z;
      const name = trace.name || "";
      if (z) for (let j = 0; j < z.length; j++) for (let i = 0; i < z[j].length; i++) rows.push([name, x[i] ?? i, y[j] ?? j, z[j][i]]);
      else for (let i = 0; i < Math.max(x.length, y.length); i++) rows.push([name, x[i] ?? i, y[i], ""]);
    }
    if (rows.every((row, i) => i === 0 || row[3] === "")) for (const row of rows) row.pop();
    return rows.map((row) => row.map(cell).join(",")).join("\n") + "\n";
  }

  function chart(target, kind, name) {
    const box = document.getElementById(target);
    const plot = box && (box.classList.contains("js-plotly-plot") ? box : box.querySelector(".js-plotly-plot"));
    if (!plot) return;
    if (kind === "csv") save(table(plot), name + ".csv");
    else window.Plotly.downloadImage(plot, { format: kind, filename: name, scale: kind === "png" ? 2 : 1 });
  }

  /** A drawing that the server makes; as a picture at twice its size. */
  async function drawing(target, kind, name) {
    const address = window.motionscapeDrawings[target]();
    if (address) await picture(address, kind, name);
  }

  async function picture(address, kind, name) {
    const answer = await fetch(address).catch(() => null);
    if (!answer || !answer.ok) {
      window.dash_clientside.set_props("notices", { sendNotifications: [{
        action: "show", title: "The picture was not saved", message: "The server did not make it; reload the page and try again.", color: "orange",
      }] });
      return;
    }
    const text = await answer.text();
    if (kind === "svg") return save(text, name + ".svg", "image/svg+xml");
    const image = new Image();
    image.src = URL.createObjectURL(new Blob([text], { type: "image/svg+xml" }));
    await image.decode();
    const canvas = document.createElement("canvas");
    const scale = Math.min(2, 16000 / image.height);
    canvas.width = Math.round(image.width * scale);
    canvas.height = Math.round(image.height * scale);
    canvas.getContext("2d").drawImage(image, 0, 0, canvas.width, canvas.height);
    URL.revokeObjectURL(image.src);
    canvas.toBlob((blob) => blob && save(blob, name + ".png", "image/png"));
  }
  window.motionscapeSavePicture = picture; // also of trees (grammar_tree.js)

  const clientside = (window.dash_clientside = window.dash_clientside || {});
  clientside.downloads = {
    fetch(ready) {
      if (ready && ready.address) {
        const link = document.createElement("a");
        link.href = ready.address;
        link.download = "";
        link.click();
      }
      return clientside.no_update;
    },
  };

  document.addEventListener("click", async (event) => {
    const button = event.target.closest && event.target.closest("[data-save]");
    if (!button) return;
    const { save: what, target, kind } = button.dataset;
    const name = `${dataset()} ${button.dataset.name}`;
    if (what === "chart") chart(target, kind, name);
    else if (what === "drawing") drawing(target, kind, name);
    else {
      const api = await window.dash_ag_grid.getApiAsync(target).catch(() => null);
      const columns = api && api.getColumns().map((column) => column.getColId()).filter((id) => !["strip", "key"].includes(id));
      if (api) api.exportDataAsCsv({ fileName: name + ".csv", columnKeys: columns });
    }
  });
})();
