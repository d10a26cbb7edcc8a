import assert from "node:assert/strict";
import { test } from "node:test";
import { groundCentre, measureStage, placeFigures } from "../../../assets/stage/layout.mjs";
import { nameFigures, shorten } from "../../../assets/stage/names.mjs";
import { restoreState, takeState } from "../../../assets/stage/state.mjs";
import { Camera } from "../../../assets/stage/camera.mjs";
import { makeTimeline, Clock } from "../../../assets/stage/timeline.mjs";
import { Traces } from "../../../assets/stage/traces.mjs";
import { madeFigure } from "./made.mjs";

const walkers = (n) => Array.from({ length: n }, (_, k) => madeFigure({ clip: `session walk ${k}`, speed: 0.01 }, {}, k));

test("laid over one another all start at the same place", () => {
  const figures = walkers(4);
  assert.deepEqual(placeFigures(figures, "overlay", 1.5, 2), []);
  for (const figure of figures) assert.deepEqual(figure.place, [0, 0]);
});

test("side by side nobody walks into another", () => {
  for (const n of [2, 5, 12]) {
    const figures = walkers(n);
    placeFigures(figures, "side", 1.5, 2);
    for (let time = 0; time <= 2; time += 0.1) {
      const roots = figures.map((figure) => [...figure.pose(time)].slice(0, 3));
      roots.forEach((a, i) => roots.slice(i + 1).forEach((b) => assert.ok(Math.hypot(a[0] - b[0], a[2] - b[2]) > 0.5)));
    }
  }
});

test("stills stand on shelves, one above the other, and do not move from their place", () => {
  const figures = walkers(7);
  const shelves = placeFigures(figures, "pose", 1.2, 2);
  assert.ok(shelves.length > 1);
  for (const figure of figures) {
    assert.ok(figure.walksInPlace);
    assert.ok(shelves.some((shelf) => shelf.level === figure.level && Math.abs(figure.place[0]) <= shelf.half));
  }
});

test("the cloud of all figures lies around their common centre", () => {
  const figures = walkers(3);
  placeFigures(figures, "overlay", 1, 2);
  const { cloud, radius } = measureStage(figures, 2);
  assert.ok(radius >= 0.7);
  const [x, z] = groundCentre(figures, [0, 0]);
  assert.ok(Number.isFinite(x) && Number.isFinite(z));
  for (let k = 0; k < cloud.length; k += 3) assert.ok(Math.hypot(cloud[k], cloud[k + 2]) < 1e-3);
  figures.forEach((figure) => (figure.visible = false));
  assert.deepEqual(groundCentre(figures, [9, 9]), [0, 0]);
});

test("names leave out what all have in common, and tell equal ones apart by their second", () => {
  const figures = walkers(3);
  nameFigures(figures);
  assert.deepEqual(figures.map((figure) => figure.name), ["0", "1", "2"]);
  const same = [madeFigure({ start: 0 }), madeFigure({ start: 30 })];
  nameFigures(same);
  assert.deepEqual(same.map((figure) => figure.name), ["0.0 s", "1.0 s"]);
  assert.equal(shorten("a rather long name", 11), "a rat…name");
  assert.equal(shorten("short", 11), "short");
});

test("a state that was taken is the state that is restored; what makes no sense is left out", () => {
  globalThis.window = { matchMedia: () => ({ matches: false }) };
  const made = () => {
    const figures = walkers(2);
    const stage = { figures, clock: new Clock(), camera: new Camera(), traces: new Traces(), layout: "overlay", sync: "warp" };
    stage.prepare = () => {
      stage.timeline = makeTimeline(figures, stage.sync, stage.layout);
      stage.clock.duration = stage.timeline.duration;
    };
    stage.prepare();
    return stage;
  };
  const stage = made();
  Object.assign(stage.clock, { time: 1.25, speed: 0.5, loop: "bounce", playing: true });
  Object.assign(stage.camera, { yaw: 1, pitch: 0.3, distance: 7, pan: [0.1, 1, 0.2], follow: false, centre: [2, 3] });
  Object.assign(stage.traces, { ghosts: true, trails: "limbs" });
  stage.figures[1].visible = false;
  stage.layout = "side";
  const taken = takeState(stage);
  const other = made();
  restoreState(other, JSON.parse(JSON.stringify(taken)));
  assert.deepEqual(takeState(other), taken);
  const before = takeState(other);
  restoreState(other, { layout: "nowhere", speed: NaN, loop: 3, camera: { yaw: "x", pan: [1] }, hidden: [1], trails: null });
  assert.deepEqual(takeState(other), before);
});
