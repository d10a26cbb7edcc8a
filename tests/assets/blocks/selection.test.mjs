import assert from "node:assert/strict";
import { test } from "node:test";
import { lightBlocks, meets, motifsToLight } from "../../../assets/blocks/selection.mjs";

const motifs = [{ id: 3, motions: [["a", 0, 30], ["b", 10, 40]] }, { id: 7, motions: [["b", 100, 130]] }];

/** A block that notes what it was told to light. */
const block = (same, motion) => {
  const told = [];
  return { told, same, drawn: { motion: () => motion, light: (...values) => told.push(values) } };
};

test("stretches are the same motion where they share half of the shorter one", () => {
  assert.ok(meets(["a", 0, 30], ["a", 15, 60]));
  assert.ok(!meets(["a", 0, 30], ["a", 16, 60]));
  assert.ok(!meets(["a", 0, 30], ["b", 0, 30]));
  assert.ok(meets(["a", 0, Infinity], ["a", 500, 510]));
});

test("motifs light by their number, else by their motion", () => {
  assert.deepEqual([...motifsToLight({ edge: "3-7" }, [], motifs)], [3, 7]);
  assert.deepEqual([...motifsToLight({ clip: "b" }, [["b", 90, 140]], motifs)], [7]);
  assert.deepEqual([...motifsToLight({}, [], motifs)], []);
});

test("where numbers mean something else, the same motion lights", () => {
  const [own, other] = [block(true, motifs[0].motions), block(false, [["c", 0, 9]])];
  lightBlocks([other, own], { motif: 3 });
  assert.deepEqual(own.told, [[{ motif: 3 }, motifs[0].motions]]);
  assert.deepEqual(other.told, [[{}, motifs[0].motions]]);
});

test("a selection of frames is the motion itself", () => {
  const one = block(false, [["c", 0, 9]]);
  lightBlocks([one], { clip: "a", start: 5, end: 9 });
  assert.deepEqual(one.told, [[{ clip: "a", start: 5, end: 9 }, [["a", 5, 9]]]]);
});
