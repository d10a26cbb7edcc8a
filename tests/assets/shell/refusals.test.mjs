import assert from "node:assert/strict";
import { test } from "node:test";
import { words } from "../../../assets/shell/refusals.mjs";

test("an ended session and a refusal are said in words", () => {
  assert.match(words(401, {})[1], /session has ended/);
  assert.deepEqual(words(403, { title: "You may not do this", error: "Only an editor may." }), ["You may not do this", "Only an editor may."]);
});

test("of anything else nothing is said", () => {
  assert.equal(words(403, {}), null);
  assert.equal(words(200, { error: "x" }), null);
  assert.equal(words(404, { error: "x" }), null);
});
