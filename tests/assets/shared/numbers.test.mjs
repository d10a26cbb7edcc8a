import assert from "node:assert/strict";
import { test } from "node:test";
import { clamp, nearest } from "../../../assets/shared/numbers.mjs";

test("the nearest entry of a rising list is the one a scan finds", () => {
  assert.equal(nearest([], 3), -1);
  const list = [0, 1, 1.5, 4, 9, 9.5];
  for (let value = -1; value < 11; value += 0.13) {
    const found = Math.abs(list[nearest(list, value)] - value);
    assert.equal(found, Math.min(...list.map((entry) => Math.abs(entry - value))));
  }
});

test("a value stays within its limits", () => {
  assert.deepEqual([-1, 0.5, 2].map((value) => clamp(value, 0, 1)), [0, 0.5, 1]);
});
