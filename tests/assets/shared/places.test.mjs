import assert from "node:assert/strict";
import test from "node:test";

globalThis.document = { addEventListener() {}, readyState: "loading" };
globalThis.window = { addEventListener() {} };
const { matching } = await import("../../../assets/shared/places.mjs");

test("all words count, and names that begin with the first come first", () => {
  const places = [
    { name: "The graph", about: "view #kicks", address: "/a" },
    { name: "Kicks", about: "board", address: "/b" },
    { name: "Map", about: "page", address: "/c" },
  ];
  assert.deepEqual(matching(places, "kick").map(({ address }) => address), ["/b", "/a"]);
  assert.deepEqual(matching(places, "kick graph").map(({ address }) => address), ["/a"]);
  assert.equal(matching(places, "").length, 3);
});

test("what is called so goes before what begins so", () => {
  const names = ["Motif 10", "Motif 0 of 1", "Motif 1"].map((name) => ({ name, about: "", address: name }));
  assert.deepEqual(matching(names, "motif 1").map(({ name }) => name), ["Motif 1", "Motif 10", "Motif 0 of 1"]);
});
