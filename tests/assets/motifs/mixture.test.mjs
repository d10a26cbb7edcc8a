import assert from "node:assert/strict";
import { test } from "node:test";
import { inStep, interpolate, readPairs, sharesOf, writePairs } from "../../../assets/motifs/mixture.mjs";
import { awayFromCorner, CORNERS, insideWeights, placeOf, weightsAt } from "../../../assets/motifs/triangle.mjs";

const close = (a, b) => a.forEach((value, k) => assert.ok(Math.abs(value - b[k]) < 1e-9, `${a} is not ${b}`));

test("shares have sum 1, also where nothing has a weight", () => {
  close(sharesOf([1, 3]), [0.25, 0.75]);
  close(sharesOf([0, 0, 0, 0]), [0.25, 0.25, 0.25, 0.25]);
});

test("weights of a link are those that were written", () => {
  assert.equal(writePairs([0, 4], [0.5, 0.123]), "0:0.5,4:0.12");
  assert.deepEqual(readPairs("0:0.5,4:0.12"), [[0, 0.5], [4, 0.12]]);
  assert.deepEqual(readPairs("0:7,nonsense,3:."), [[0, 1], [3, 0]]);
  assert.deepEqual(readPairs(undefined), []);
});

test("a curve is straight between its points and level outside", () => {
  assert.deepEqual([-1, 0, 0.5, 1, 2, 9].map((x) => interpolate(x, [0, 1, 3], [0, 10, 20])), [0, 0, 5, 10, 15, 20]);
});

test("a mixture of two motions in step takes the time between theirs, and both end with it", () => {
  const motion = (seconds, frames) => ({ motion: 0, seconds, fps: 30, start: 0, end: frames });
  const used = [{ share: 0.5, one: motion([0, 1, 2], 61) }, { share: 0.5, one: motion([0, 2, 4], 121) }];
  const { mixture, sources } = inStep(used);
  assert.equal(mixture.length, 91);
  assert.deepEqual([sources[0][0], sources[0].at(-1), sources[1].at(-1)], [0, 60, 120]);
  assert.deepEqual([sources[0][45], sources[1][45]], [30, 60]);
});

test("a point of the triangle has the weights that lead to it", () => {
  for (const weights of [[0.2, 0.3, 0.5], [1 / 3, 1 / 3, 1 / 3], [0.5, 0.5, 0]]) {
    const [x, y] = placeOf(weights);
    close(weightsAt(x, y), weights);
  }
  CORNERS.forEach(([x, y], k) => assert.deepEqual(weightsAt(x, y), [0, 1, 2].map((i) => Number(i === k))));
});

test("outside the triangle no weight is negative, and a corner holds the point", () => {
  for (const [x, y] of [[0, 0], [400, 300], [150, -50]]) {
    const weights = weightsAt(x, y);
    assert.ok(weights.every((w) => w >= 0) && Math.abs(weights.reduce((a, b) => a + b) - 1) < 1e-9);
  }
  assert.deepEqual(insideWeights([0.98, 0.02, 0]), [1, 0, 0]);
  assert.deepEqual(awayFromCorner(0, [0, -1]), [1, 0, 0]); // nothing leads up from the top
  close(awayFromCorner(0, [1, 0]), [0.94, 0, 0.06]);
});
