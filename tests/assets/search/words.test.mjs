import assert from "node:assert/strict";
import { test } from "node:test";
import { scoreWords } from "../../../assets/search/words.mjs";

test("chances are told in percent, other scores as they are", () => {
  assert.equal(scoreWords(0.8732, true), "87 %");
  assert.equal(scoreWords(0.004, true), "< 1 %");
  assert.equal(scoreWords(0.998, true), "> 99 %");
  assert.equal(scoreWords(1, true), "100 %");
  assert.equal(scoreWords(0.8732, false), "0.873");
});
