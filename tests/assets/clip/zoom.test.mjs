import assert from "node:assert/strict";
import { test } from "node:test";
import { spanWithin } from "../../../assets/clip/zoom.mjs";

const CLIP = { frames: 301, fps: 60 }; // five seconds

test("a span within the clip stays as it is", () => {
  assert.deepEqual(spanWithin(1, 3, CLIP), { span: [1, 3], whole: false });
});

test("one that leaves the clip is moved in, one that is longer is all of it", () => {
  assert.deepEqual(spanWithin(-2, 0, CLIP).span, [0, 2]);
  assert.deepEqual(spanWithin(4.5, 6.5, CLIP).span, [3, 5]);
  assert.deepEqual(spanWithin(-10, 90, CLIP), { span: [0, 5], whole: true });
});

test("a span holds at least four frames, and a clip of one frame has one", () => {
  const { span } = spanWithin(2, 2, CLIP);
  assert.ok(Math.abs(span[1] - span[0] - 4 / 60) < 1e-9);
  assert.deepEqual(spanWithin(0, 1, { frames: 1, fps: 50 }), { span: [0, 0.02], whole: true });
});
