import assert from "node:assert/strict";
import test from "node:test";

globalThis.document = { addEventListener() {}, readyState: "loading" };
globalThis.window = { addEventListener() {} };
const { matching } = await import("../../../assets/boards/palette.mjs");

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
