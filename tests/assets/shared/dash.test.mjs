import assert from "node:assert/strict";
import { beforeEach, test } from "node:test";

import { changeView } from "../../../assets/shared/dash.mjs";

let view;
let writes;

beforeEach(() => {
  view = { look: "agree", query: "a:1-2" };
  writes = 0;
  globalThis.dash_component_api = { getLayout: () => ({ props: { data: view } }) };
  globalThis.dash_clientside.set_props = (_store, { data }) => { view = data; writes += 1; };
});

test("two changes in a row both count", () => {
  changeView({ parts: "head:1" });
  changeView({ level: "clip", look: "" });
  assert.deepEqual(view, { query: "a:1-2", parts: "head:1", level: "clip" });
});

test("values become text, and nothing or an empty text takes a key out", () => {
  changeView({ top: 60, query: null, look: undefined });
  assert.deepEqual(view, { top: "60" });
});

test("what changes nothing is not written", () => {
  changeView({ look: "agree", parts: "" });
  assert.equal(writes, 0);
});

test("an app that shows nothing yet has an empty view", () => {
  view = null;
  changeView({ look: "agree" });
  assert.deepEqual(view, { look: "agree" });
});
