// Where figures stand, and how much of the stage they need.
(function (parts) {
  "use strict";

  const LANE = { least: 1.1, most: 2.4, gap: 0.35 };

  /** "overlay": all start at the origin. "side": each in a lane of its own, in rows that suit the view's shape. */
  function placeFigures(figures, layout, aspect) {
    for (const figure of figures) {
      figure.place = [0, 0];
      figure.walksInPlace = false;
    }
    const shown = figures.filter((figure) => figure.visible);
    if (layout !== "side" || shown.length < 2) return;
    const boxes = shown.map((figure) => figure.extent());
    const span = (low, high) => Math.max(...boxes.map((b) => b[high] - b[low]));
    const width = Math.min(Math.max(span(0, 1) + LANE.gap, LANE.least), LANE.most);
    const depth = Math.min(Math.max(span(2, 3) + LANE.gap, 1.6), 3.2);
    const columns = Math.min(shown.length, Math.max(1, Math.round(Math.sqrt((shown.length * aspect * 1.1 * depth) / width / 1.6))));
    const rows = Math.ceil(shown.length / columns);
    shown.forEach((figure, k) => {
      const [row, column] = [Math.floor(k / columns), k % columns];
      const inRow = row < rows - 1 ? columns : shown.length - columns * (rows - 1);
      const box = boxes[k];
      figure.walksInPlace = box[1] - box[0] > LANE.most || box[3] - box[2] > 3.2;
      const middle = figure.walksInPlace ? [0, 0] : [(box[0] + box[1]) / 2, (box[2] + box[3]) / 2];
      figure.place = [(column - (inRow - 1) / 2) * width - middle[0], ((rows - 1) / 2 - row) * depth - middle[1]];
    });
  }

  /** Mean place on the ground of the visible figures' roots, from their current points. */
  function groundCentre(figures, out) {
    let [x, z, n] = [0, 0, 0];
    for (const figure of figures) {
      if (!figure.visible) continue;
      const root = 3 * figure.header.root;
      x += figure.points[root];
      z += figure.points[root + 2];
      n++;
    }
    out[0] = n ? x / n : 0;
    out[1] = n ? z / n : 0;
    return out;
  }

  /** Furthest that any joint gets from the figures' common centre on the ground, and the greatest height. */
  function measureStage(figures, duration, samples = 24) {
    const centre = [0, 0];
    let [radius, height] = [0.7, 1.2];
    for (let s = 0; s < samples; s++) {
      for (const figure of figures) figure.pose((duration * s) / (samples - 1));
      groundCentre(figures, centre);
      for (const { visible, points } of figures) {
        if (!visible) continue;
        for (let k = 0; k < points.length; k += 3) {
          radius = Math.max(radius, Math.hypot(points[k] - centre[0], points[k + 2] - centre[1]));
          height = Math.max(height, points[k + 1]);
        }
      }
    }
    return { radius, height };
  }

  Object.assign(parts, { placeFigures, groundCentre, measureStage });
})((window.motionscapeStageParts ||= {}));
