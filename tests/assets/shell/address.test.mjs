import assert from "node:assert/strict";
import { test } from "node:test";
import { addressOf, pageOf, stageOfLink, stateOfLink } from "../../../assets/shell/address.mjs";

const SHOWN = {
  dataset: "demo", selection: { motif: 3 }, view: { side: "walk", other: "x", rho: "2" },
  keys: { motifs: ["rho", "side"], library: ["rho"] }, chosen: '{"motif":3}', stage: { time: 1.5, speed: "" },
};

test("a link has the data set, the page's part of the view, the selection and the Stage", () => {
  assert.equal(addressOf("/motifs", SHOWN), "/motifs?dataset=demo&rho=2&side=walk&motif=3&time=1.5");
  assert.equal(addressOf("/library", SHOWN), "/library?dataset=demo&rho=2&motif=3&time=1.5");
});

test("without a selection the Stage has no place in the link", () => {
  assert.equal(addressOf("/motifs", { ...SHOWN, selection: {}, chosen: "{}", view: { rho: "2" } }), "/motifs?dataset=demo&rho=2");
});

test("commas and colons stay readable, all else is escaped", () => {
  const address = addressOf("/search", { ...SHOWN, selection: null, keys: { search: ["query"] }, view: { query: "a:1-2,b & c" } });
  assert.equal(address, "/search?dataset=demo&query=a:1-2,b+%26+c&time=1.5");
  assert.equal(new URL(address, "http://here").searchParams.get("query"), "a:1-2,b & c");
});

test("the state that a link asks for is the state it was written from", () => {
  const camera = { yaw: 0.5, pitch: 0.25, distance: 4, pan: [0, 1, 0.5], follow: false };
  const link = stageOfLink({ time: 1.25, playing: false, speed: 0.5, layout: "side", camera }, true);
  const text = Object.fromEntries(Object.entries(link).map(([key, value]) => [key, String(value)]));
  assert.deepEqual(stateOfLink(text), { time: 1.25, playing: false, speed: 0.5, layout: "side", camera });
  assert.deepEqual(stageOfLink({ time: 1, playing: true, speed: 1, layout: "overlay", camera }, false), { time: "", speed: "", layout: "", camera: "" });
  assert.deepEqual(stateOfLink({}), {});
});

test("the page without a name is the library", () => {
  assert.deepEqual(["/", "", "/motifs", "/clip/"].map(pageOf), ["library", "library", "motifs", "clip"]);
});
