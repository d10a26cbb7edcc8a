import assert from "node:assert/strict";
import { test } from "node:test";
import { words } from "../../../assets/shell/refusals.mjs";

test("an ended session and a refusal are said in words", () => {
  assert.match(words(401, { title: "Nobody is signed in", error: "Your session has ended." })[1], /^Your session has ended. Reload/);
  assert.deepEqual(words(403, { title: "You may not do this", error: "Only an editor may." }), ["You may not do this", "Only an editor may."]);
});

test("of anything else nothing is said", () => {
  assert.equal(words(401, {}), null);
  assert.equal(words(403, {}), null);
  assert.equal(words(200, { error: "x" }), null);
  assert.equal(words(404, { error: "x" }), null);
});
