import assert from "node:assert/strict";
import { test } from "node:test";

import { clock, percent, plural } from "../../../assets/shared/words.mjs";

test("a clock counts minutes, seconds and tenths, rounded once", () => {
  assert.equal(clock(0), "0:00.0");
  assert.equal(clock(75.25), "1:15.3");
  assert.equal(clock(59.96), "1:00.0");
  assert.equal(clock(3600), "60:00.0");
});

test("counts agree with their noun", () => {
  assert.equal(plural(1, "clip"), "1 clip");
  assert.equal(plural(0, "clip"), "0 clips");
  assert.equal(plural(2, "body", "bodies"), "2 bodies");
});

test("shares are whole percent", () => {
  assert.equal(percent(0.456), "46 %");
  assert.equal(percent(1), "100 %");
});
