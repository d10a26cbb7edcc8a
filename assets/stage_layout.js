// Where figures stand, and how much of the stage they need.
(function (parts) {
  "use strict";

  const LANE = { least: 1.0, most: 2.4, gap: 0.3 };
  const ROW = { least: 1.5, most: 3.2 };
  const STILL_LANE = { least: 0.75, most: 2.0, gap: 0.2 };
  const STILL_ROW = 2.2;
  const TURN = 0.5; // radians: side by side, the camera looks straight and the figures stand askew

  /**
   * "overlay": all start at the origin. "side": each in a lane of its own, in rows that suit the view's shape. "pose":
   * the same for stills, which stay on their spot and need no more room than one posture.
   */
  function placeFigures(figures, layout, aspect, duration) {
    const still = layout === "pose";
    for (const figure of figures) {
      figure.place = [0, 0];
      figure.walksInPlace = still;
      figure.path = null;
      figure.stand(still ? figure.frameAt(duration / 2) : 0);
    }
    const shown = figures.filter((figure) => figure.visible);
    if (layout === "overlay" || shown.length < 2) return;
    for (const figure of shown) figure.turn(TURN);
    const boxes = shown.map((figure) => (still ? figure.extent(duration / 2, duration / 2, 1) : figure.extent()));
    const span = (low, high) => Math.max(...boxes.map((b) => b[high] - b[low]));
    const lane = still ? STILL_LANE : LANE;
    const width = Math.min(Math.max(span(0, 1) + lane.gap, lane.least), lane.most);
    const depth = still ? STILL_ROW : Math.min(Math.max(span(2, 3) + LANE.gap, ROW.least), ROW.most);
    // seen from the front, rows cost little height: rather few long ones
    const wanted = Math.round(Math.sqrt((shown.length * aspect * (0.6 * depth + 0.8)) / width));
    const rows = Math.ceil(shown.length / Math.max(wanted, 2));
    const columns = Math.ceil(shown.length / rows);
    shown.forEach((figure, k) => {
      const [row, column] = [Math.floor(k / columns), k % columns];
      const inRow = row < rows - 1 ? columns : shown.length - columns * (rows - 1);
      const box = boxes[k];
      figure.room = width;
      figure.walksInPlace = still || box[1] - box[0] > LANE.most || box[3] - box[2] > ROW.most;
      const middle = figure.walksInPlace ? [0, 0] : [(box[0] + box[1]) / 2, (box[2] + box[3]) / 2];
      const stagger = rows > 1 ? (row % 2 ? 0.25 : -0.25) * width : 0; // seen between those in front
      figure.place = [(column - (inRow - 1) / 2) * width + stagger - middle[0], ((rows - 1) / 2 - row) * depth - middle[1]];
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

  /**
   * All places that joints take relative to the figures' common centre on the ground, as seen by a camera that follows
   * it: {cloud: (n, 3) sampled over the motion, radius: the furthest from the centre on the ground}.
   */
  function measureStage(figures, duration, samples = 24) {
    const shown = figures.filter((figure) => figure.visible);
    const cloud = new Float32Array(samples * shown.reduce((sum, figure) => sum + figure.points.length, 0));
    const centre = [0, 0];
    let radius = 0.7;
    let n = 0;
    for (let s = 0; s < samples; s++) {
      for (const figure of shown) figure.pose((duration * s) / (samples - 1));
      groundCentre(shown, centre);
      for (const { points } of shown) {
        for (let k = 0; k < points.length; k += 3) {
          cloud[n++] = points[k] - centre[0];
          cloud[n++] = points[k + 1];
          cloud[n++] = points[k + 2] - centre[1];
          radius = Math.max(radius, Math.hypot(cloud[n - 3], cloud[n - 1]));
        }
      }
    }
    return { cloud, radius };
  }

  /** Where the camera stands at first: before a single group, or before rows. */
  const homeView = (figures, layout) => (layout !== "overlay" && figures.length > 1 ? { yaw: 0.06, pitch: 0.34 } : { yaw: 0.62, pitch: 0.2 });

  Object.assign(parts, { homeView, placeFigures, groundCentre, measureStage });
})((window.motionscapeStageParts ||= {}));
