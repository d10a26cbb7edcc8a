import assert from "node:assert/strict";
import { test } from "node:test";
import { visited } from "../../../assets/grammar/history.mjs";

test("a step back and forward moves in the past; a new routine cuts what could be redone", () => {
  let past = { key: "k", list: [], at: -1 };
  for (const sentence of ["a", "b", "c"]) past = visited(past, sentence);
  assert.deepEqual(past, { key: "k", list: ["a", "b", "c"], at: 2 });
  past = visited(past, "b");
  assert.equal(past.at, 1);
  assert.equal(visited(past, "b"), past);
  assert.equal(visited(past, "c").at, 2);
  assert.deepEqual(visited(past, "d").list, ["a", "b", "d"]);
  for (let k = 0; k < 300; k++) past = visited(past, `x${k}`);
  assert.deepEqual([past.list.length, past.at, past.list.at(-1)], [100, 99, "x299"]);
});
