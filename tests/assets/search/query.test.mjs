import assert from "node:assert/strict";
import { beforeEach, test } from "node:test";
import { canGoBack, escapeName, goBack, nodesOf, now, remember, searchFor, writeQuery } from "../../../assets/search/state.mjs";
import { evenWeights, readWeights, sameWeights, writeWeights } from "../../../assets/search/weights.mjs";

const BODY = {
  leaves: ["torso", "head", "left_arm", "left_hand"],
  nodes: { whole: ["torso", "head", "left_arm", "left_hand"], upper: ["torso", "head"], left_arm_hand: ["left_arm", "left_hand"], torso: ["torso"], head: ["head"], left_arm: ["left_arm"], left_hand: ["left_hand"] },
  words: {},
};
const changes = [];
globalThis.dash_clientside.set_props = (store, { data }) => changes.push([store, data]);
globalThis.dash_component_api = { getLayout: () => ({ props: { data: now.view } }) };

beforeEach(() => {
  changes.length = 0;
  Object.assign(now, { body: BODY, view: {}, found: null });
});

test("names are escaped as the server reads them", () => {
  assert.equal(escapeName("Walk 1_a.b-c"), "Walk 1_a.b-c");
  assert.equal(escapeName("a/b:c,d~"), "a~2fb~3ac~2cd~7e");
  assert.equal(escapeName("für"), "f~c3~bcr");
});

test("parts are named by the fewest nodes", () => {
  assert.deepEqual(nodesOf(BODY.leaves), ["whole"]);
  assert.deepEqual(nodesOf(["head", "left_arm", "left_hand"]), ["left_arm_hand", "head"]);
});

test("a query has its parts only where they are not the whole body, and drops pieces that give nothing", () => {
  const whole = { clip: "a", dataset: "", start: 0, end: 9, leaves: [...BODY.leaves] };
  assert.equal(writeQuery([whole]), "a:0-9");
  assert.equal(writeQuery([{ ...whole, leaves: ["torso", "head"], dataset: "~upload~1" }, { ...whole, leaves: [] }]), "upper:a:0-9:~7eupload~7e1");
});

test("a change of the query is remembered and can be taken back", () => {
  now.view = { query: "a:0-9", parts: "head:1" };
  searchFor([{ clip: "b", dataset: "", start: 1, end: 2, leaves: [...BODY.leaves] }]);
  assert.deepEqual(changes.pop(), ["view", { query: "b:1-2", parts: "head:1" }]);
  now.view = { query: "b:1-2" };
  assert.ok(canGoBack());
  goBack();
  assert.deepEqual(changes.pop(), ["view", { query: "a:0-9", parts: "head:1" }]);
  remember();
});

test("weights of a link are those that were written", () => {
  const weights = { torso: 0, head: 9, left_arm: 10, left_hand: 0 };
  assert.equal(writeWeights(weights, BODY), "head:9,left_arm:10");
  assert.deepEqual(readWeights("head:9,left_arm:10", BODY), weights);
  assert.equal(writeWeights(evenWeights(BODY), BODY), "");
});

test("a larger part shares its weight, nonsense is the whole body", () => {
  assert.deepEqual(readWeights("left_arm_hand:4,torso:-1,nose:3", BODY), { torso: 0, head: 0, left_arm: 2, left_hand: 2 });
  assert.deepEqual(readWeights("nose:3", BODY), evenWeights(BODY));
  assert.deepEqual(readWeights(undefined, BODY), evenWeights(BODY));
});

test("only ratios count", () => {
  assert.ok(sameWeights({ torso: 1, head: 2 }, { torso: 5, head: 10, left_arm: 0 }, BODY));
  assert.ok(!sameWeights({ torso: 1, head: 2 }, { torso: 5, head: 9 }, BODY));
});
