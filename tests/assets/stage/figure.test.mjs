import assert from "node:assert/strict";
import { test } from "node:test";
import { standing, timeOf } from "../../../assets/stage/state.mjs";
import { madeFigure } from "./made.mjs";

test("frames of the stage and of the recording lead to one another", () => {
  const figure = madeFigure({ start: 40, frames: 31, fps: 60, step: 2 });
  for (const frame of [40, 47, 60, 100]) assert.equal(figure.recordedFrame(figure.timeAt(frame)), frame);
  assert.equal(figure.ownDuration, 1);
  assert.equal(figure.timeAt(1000), figure.duration);
});

test("a figure stands at the origin on the floor, and joints between frames lie between", () => {
  const figure = madeFigure({ speed: 0.03, floor: 0.25 });
  const close = (points, wanted) => wanted.forEach((value, k) => assert.ok(Math.abs(points[k] - value) < 1e-5, `${points}`));
  close(figure.pose(0), [0, 0.75, 0]);
  close(figure.pose(0.5 / 30), [0, 0.75, 0.015]);
  figure.place = [3, -1];
  figure.level = 2;
  close(figure.pose(1 / 30), [3, 2.75, -0.97]);
  figure.walksInPlace = true;
  close(figure.pose(1), [3, 2.75, -1]);
});

test("coloured spans hold their frames, cut to the segment", () => {
  globalThis.document = { createElement: () => ({ getContext: () => null }) };
  const figure = madeFigure({ start: 10, frames: 21 }, { colours: [{ start: 0, end: 15, colour: "red", label: "a" }, { start: 15, end: 90, colour: "blue", label: "b" }, { start: 90, end: 99, colour: "blue", label: "c" }] });
  assert.deepEqual(figure.spans.map(({ start, end, label }) => [start, end, label]), [[10, 15, "a"], [15, 31, "b"]]);
  assert.equal(figure.spanAt(14).label, "a");
  assert.equal(figure.spanAt(15).label, "b");
  assert.equal(figure.spanAt(31), undefined);
});

test("a warp of one number or of none is no warp", () => {
  assert.equal(madeFigure({}, { warp: [3] }).warp, null);
  assert.equal(madeFigure({}, { warp: [0, NaN, 2] }).warp, null);
  assert.equal(madeFigure({}, { warp: [0, 1, 2] }).warp.length, 3);
});

test("a frame of a clip is found on the figure whose segment holds it, on a visible one of several", () => {
  const figures = [madeFigure({ start: 0 }, { dataset: "a" }, 0), madeFigure({ start: 100 }, { dataset: "a" }, 1), madeFigure({ start: 100 }, { dataset: "b" }, 2)];
  assert.equal(timeOf(figures, { clip: "walk", frame: 130 }), figures[1].timeAt(130));
  assert.equal(timeOf(figures, { clip: "walk", frame: 30 }), figures[0].timeAt(30));
  assert.equal(timeOf(figures, { clip: "walk", frame: 130, dataset: "c" }), null);
  assert.equal(timeOf(figures, { clip: "other", frame: 1 }), null);
  assert.equal(timeOf(figures, { clip: "walk", frame: NaN }), null);
  const at = standing(figures[1], 1);
  assert.deepEqual([at.index, at.dataset, at.frame, at.span], [1, "a", 130, null]);
});
