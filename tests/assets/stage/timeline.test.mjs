import assert from "node:assert/strict";
import { test } from "node:test";
import { Clock, makeTimeline, SPEEDS } from "../../../assets/stage/timeline.mjs";
import { madeFigure } from "./made.mjs";

const running = (loop, time = 0) => Object.assign(new Clock(), { duration: 2, loop, playing: true, time });

test("a clock that repeats starts again, one that bounces turns round, one that plays once stops", () => {
  const repeating = running("loop", 1.75);
  repeating.advance(0.5);
  assert.equal(repeating.time, 0.25);
  assert.ok(repeating.jumped);
  const bouncing = running("bounce", 1.75);
  bouncing.advance(0.5);
  assert.equal(bouncing.time, 1.75);
  bouncing.advance(0.5);
  assert.equal(bouncing.time, 1.25);
  const once = running("once", 1.75);
  once.advance(0.5);
  assert.deepEqual([once.time, once.playing], [2, false]);
  once.play();
  assert.deepEqual([once.time, once.playing], [0, true]);
});

test("speed goes step by step and stays within what there is", () => {
  const clock = new Clock();
  clock.changeSpeed(1);
  assert.equal(clock.speed, 1.5);
  clock.changeSpeed(-100);
  assert.equal(clock.speed, SPEEDS[0]);
  clock.changeSpeed(100);
  assert.equal(clock.speed, SPEEDS.at(-1));
});

test("seeking stays within the time there is", () => {
  const clock = running("loop");
  for (const [to, at] of [[-1, 0], [5, 2], [1.25, 1.25]]) {
    clock.seek(to);
    assert.equal(clock.time, at);
  }
});

test("without warps each figure runs at its own pace and the longest says how long", () => {
  const figures = [madeFigure({ frames: 31 }), madeFigure({ frames: 61 })];
  const timeline = makeTimeline(figures, "warp", "overlay");
  assert.deepEqual([timeline.warped, timeline.reference, timeline.duration], [false, 1, 2]);
  assert.equal(figures[0].frameAt(0.5), 15);
  assert.equal(figures[0].frameAt(1.7), 30);
});

test("in step, time is that of the motion whose warp runs straight", () => {
  const straight = Array.from({ length: 61 }, (_, k) => k);
  const twice = straight.map((k) => 2 * k);
  const figures = [madeFigure({ frames: 121 }, { warp: twice }), madeFigure({ frames: 61 }, { warp: straight })];
  const timeline = makeTimeline(figures, "warp", "overlay");
  assert.deepEqual([timeline.warped, timeline.reference, timeline.duration], [true, 1, 2]);
  assert.equal(figures[0].frameAt(1), 60);
  assert.equal(figures[1].frameAt(1), 30);
});

test("stills pass through the same share of their motions, half-way at the frame that is asked for", () => {
  const figures = [madeFigure({ frames: 61 }), madeFigure({ frames: 21, start: 100 }, { frame: 115 })];
  const { duration } = makeTimeline(figures, "start", "pose");
  assert.equal(duration, 2);
  assert.equal(figures[0].recordedFrame(duration / 2), 30);
  assert.equal(figures[1].recordedFrame(duration / 2), 115);
  assert.equal(figures[0].recordedFrame(0), 0);
});
