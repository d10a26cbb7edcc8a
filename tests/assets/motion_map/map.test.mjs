import assert from "node:assert/strict";
import { test } from "node:test";
import { dragJoint } from "../../../assets/motion_map/bones.mjs";
import { MapData } from "../../../assets/motion_map/data.mjs";
import { paceOf, readKeys, readNumber, writeKeys } from "../../../assets/motion_map/link.mjs";

const RUNS = [ // clip, start, end, node, distance, ahead, aside
  [0, 0, 4, 0, 0, 1, 0], [0, 5, 9, 1, 0, 1, 0], [0, 10, 14, 3, 0, 0, 0], [0, 15, 19, 0, 0, -1, 0], [0, 20, 24, 3, 0, 0, 2],
  [1, 0, 9, 3, 0, 0, 0], [1, 10, 19, 0, 0, 1, 0], [1, 20, 29, 2, 0, 1, 0], [1, 30, 39, 3, 0, 1, 0],
];

/** A map of 2 by 2 nodes: an upper arm and a forearm that bend more from node to node. */
function madeMap() {
  const header = {
    grid: [2, 2], fps: 30, runs: RUNS.length, joints: ["shoulder", "elbow", "hand"], roles: ["chest", "left_elbow", "left_wrist"],
    sides: ["centre", "left", "left"], parents: [-1, 0, 1], lengths: [0.2, 0.3, 0.25], usual: 0.1, regions: [0, 0, 1, 1], icons: [[0, 0]],
    clips: [{ name: "a", frames: 50, fps: 60 }, { name: "b", frames: 40, fps: 30 }],
  };
  const text = new TextEncoder().encode(JSON.stringify(header).padEnd(Math.ceil(JSON.stringify(header).length / 4) * 4));
  const buffer = new ArrayBuffer(4 + text.length + 4 * (4 * 9 + 7 * RUNS.length));
  new DataView(buffer).setUint32(0, text.length, true);
  new Uint8Array(buffer).set(text, 4);
  let at = 4 + text.length;
  const weights = new Float32Array(buffer, at, 36);
  [0, 0.1, 0.5, 1].forEach((bend, node) => weights.set([0, 0.2, 0, 0.3, 0.2, 0, 0.3 + 0.25 * Math.cos(bend), 0.2 + 0.25 * Math.sin(bend), 0], 9 * node));
  at += 4 * 36;
  [0, 1, 2, 3].forEach((k) => (new Int32Array(buffer, at, RUNS.length).set(RUNS.map((run) => run[k])), at += 4 * RUNS.length));
  [4, 5, 6].forEach((k) => (new Float32Array(buffer, at, RUNS.length).set(RUNS.map((run) => run[k])), at += 4 * RUNS.length));
  return new MapData(buffer, "key");
}

/** All chains of runs through the keys, in order; of those with one end the latest start, as the search says. */
function scan(map, keys, reach) {
  const passes = keys.map((key) => RUNS.map((run, r) => r).filter((r) => RUNS[r][3] === key || map.distances(key)[RUNS[r][3]] < reach));
  let chains = passes[0].map((r) => [r]);
  for (const pass of passes.slice(1)) {
    chains = chains.flatMap((chain) => {
      const next = pass.find((r) => r > chain.at(-1) && RUNS[r][0] === RUNS[chain.at(-1)][0]);
      return next === undefined ? [] : [[...chain, next]];
    });
  }
  const latest = new Map(chains.map((chain) => [chain.at(-1), chain]));
  return [...latest.values()].map((chain) => [RUNS[chain[0]][0], RUNS[chain[0]][1], RUNS[chain.at(-1)][2]]).sort();
}

test("the search finds what a scan of all runs finds, for any keys and reach", () => {
  const map = madeMap();
  for (const keys of [[0], [3], [0, 3], [3, 0], [0, 3, 0], [0, 1, 3], [2, 2], [0, 0, 3]]) {
    for (const reach of [0, 0.05, 0.2, 2]) {
      const found = map.search(keys, reach, null).map(({ clip, start, end }) => [clip, start, end]).sort();
      assert.deepEqual(found, scan(map, keys, reach), `${keys} within ${reach}`);
    }
  }
  assert.deepEqual(map.search([], 1, null), []);
});

test("hits come best first", () => {
  const hits = madeMap().search([0, 3], 0.2, null);
  assert.ok(hits.every((hit, k) => k === 0 || hits[k - 1].distance <= hit.distance + 2e-5));
});

test("a pace leaves out runs that travel otherwise", () => {
  const map = madeMap();
  const clips = (pace) => map.search([0], 0, pace).map((hit) => [hit.clip, hit.start]);
  assert.equal(clips(null).length, 3);
  assert.deepEqual(clips({ slowest: 0, fastest: Infinity, way: "backward" }), [[0, 15]]);
  assert.deepEqual(clips({ slowest: 2, fastest: 9, way: "any" }), []);
  assert.deepEqual(map.search([3], 0, { slowest: 0, fastest: 9, way: "left" }).map((hit) => hit.start), [20]);
});

test("stretches are told in frames of the clip's own rate", () => {
  const map = madeMap();
  assert.deepEqual(map.segment({ clip: 0, start: 5, end: 9 }), { clip: "a", start: 10, end: 18 });
  assert.deepEqual(map.segment({ clip: 1, start: 39, end: 90 }), { clip: "b", start: 39, end: 40 });
});

test("every frame lies on the node of its run", () => {
  const map = madeMap();
  for (const [clip, start, end, node] of RUNS) {
    const { name, fps } = map.clips[clip];
    for (const frame of [start, end]) assert.equal(map.nodeAt(name, (frame * fps) / 30), node);
  }
  assert.equal(map.nodeAt("a", 9999), -1);
  assert.equal(map.nodeAt("nobody", 0), -1);
});

test("postures have bones at their lengths, and the nearest node to a node is itself", () => {
  const map = madeMap();
  for (let node = 0; node < map.n; node++) {
    const posture = map.posture(node);
    [[0, 1, 0.3], [1, 2, 0.25]].forEach(([a, b, length]) => {
      const size = Math.hypot(...[0, 1, 2].map((k) => posture[3 * a + k] - posture[3 * b + k]));
      assert.ok(Math.abs(size - length) < 1e-6);
    });
    assert.equal(map.nearest(map.model(node)).node, node);
  }
});

test("a joint that is dragged goes there, bones keep their lengths, what is fixed stays", () => {
  const map = madeMap();
  const goal = [0.15, 0.55, 0];
  const posture = dragJoint(map, map.posture(0), 2, goal);
  const joint = (j) => [0, 1, 2].map((k) => posture[3 * j + k]);
  const apart = (a, b) => Math.hypot(...a.map((v, k) => v - b[k]));
  assert.ok(apart(joint(2), goal) < 0.02);
  assert.ok(Math.abs(apart(joint(0), joint(1)) - 0.3) < 1e-6 && Math.abs(apart(joint(1), joint(2)) - 0.25) < 1e-6);
  assert.ok(apart(joint(0), [0, 0.2, 0]) < 1e-6);
  const far = dragJoint(map, map.posture(0), 2, [9, 9, 9]);
  assert.ok(Math.abs(apart([far[0], far[1], far[2]], [far[6], far[7], far[8]]) - 0.55) < 1e-3); // stretched out
});

test("keys of a link are those that were written; what is not on the map is left out", () => {
  const map = madeMap();
  assert.equal(writeKeys([3, 0], map), "1-1,0-0");
  assert.deepEqual(readKeys("1-1,0-0", map), [3, 0]);
  assert.deepEqual(readKeys("7-7,x,1-0,-1-0", map), [2]);
  assert.deepEqual(readKeys(undefined, map), []);
  assert.equal(readKeys(Array(50).fill("0-0").join(), map).length, 20);
});

test("paces and numbers of a link", () => {
  assert.equal(paceOf({}), null);
  assert.deepEqual(paceOf({ pace: "0.5-1.5", way: "left" }), { slowest: 0.5, fastest: 1.5, way: "left" });
  assert.deepEqual(paceOf({ pace: "2-1", way: "backward" }), { slowest: 0, fastest: Infinity, way: "backward" });
  assert.equal(paceOf({ pace: "a-b", way: "up" }), null);
  assert.deepEqual([readNumber("1.5", 0), readNumber("-1", 7), readNumber(undefined, 3), readNumber("1e9", 2)], [1.5, 7, 3, 2]);
});
