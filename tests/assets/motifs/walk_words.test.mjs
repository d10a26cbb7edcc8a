import assert from "node:assert/strict";
import { test } from "node:test";
import { filled, waysText, withoutGap } from "../../../assets/motifs/walk_words.mjs";

test("a gap is filled by the way round, wherever it occurs", () => {
  assert.deepEqual(filled([1, 4, 2, 1, 4], [1, 4], [1, 7, 8, 4]), [1, 7, 8, 4, 2, 1, 7, 8, 4]);
  assert.deepEqual(filled([4, 1], [1, 4], [1, 7, 4]), [4, 1]);
});

test("without the motif after a gap there is none", () => {
  assert.deepEqual(withoutGap([1, 4, 2, 1, 4], [1, 4]), [1, 2, 1]);
  assert.deepEqual(withoutGap([4, 1], [1, 4]), [4, 1]);
});

test("what the graph lets one walk, in words", () => {
  const walk = { inputs: {}, motifs: Array(9).fill({}), parts: [6, 3], dead: [4, 5], further: [] };
  assert.equal(waysText(walk), "From 6 of 9 motifs one can come back to each other; 1 more such part. Dead ends, where nothing leads on: 4, 5 (marked in the graph).");
  assert.match(waysText({ ...walk, dead: Array.from({ length: 13 }, (_, k) => k) }), /Dead ends, where nothing leads on: 13 motifs/);
  assert.equal(waysText({ ...walk, parts: [9], dead: [], inputs: { extra: "1" } }), "No further transition points are good enough.");
  assert.equal(waysText({}), "");
});
