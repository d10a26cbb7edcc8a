import assert from "node:assert/strict";
import { test } from "node:test";
import { freshBatch, kinds, leftOut, sizeInWords, takeFiles } from "../../../assets/library/batch.mjs";

const LIMITS = { fileBytes: 1000, totalBytes: 2500, files: 4, suffixes: [".bvh", ".amc", ".amc.gz", ".asf", ".csv", ".zip"] };
const file = (path, size = 100, lastModified = 1) => ({ file: { name: path.split("/").pop(), size, lastModified }, path });
const taken = (files, batch = freshBatch()) => [batch, takeFiles(batch, files, LIMITS)];

test("files that may be sent wait in the queue; others are left out with the reason", () => {
  const [batch, items] = taken([file("a.bvh"), file("b.bvh", 1001), file("notes.bvh.txt")]);
  assert.deepEqual(items.map((item) => item.state), ["waiting", "error", "error"]);
  assert.match(items[1].message, /too large: 1 kB; a file may have 1 kB/);
  assert.match(items[2].message, /not a kind of file/);
  assert.equal(batch.queue.length, 1);
});

test("of a folder, files that are not read are left out and named; a single one is refused", () => {
  const [batch, items] = taken([file("a.bvh"), file("readme.txt"), file("b.fbx"), file("c.FBX")]);
  assert.deepEqual([items.length, batch.ignored], [1, { TXT: 1, FBX: 2 }]);
  assert.equal(leftOut(batch), "2 FBX, 1 TXT left out; convert motion to BVH, with Blender for example");
  assert.equal(leftOut(taken([file("a.bvh"), file("LICENCE")])[0]), "1 other left out");
  assert.equal(leftOut(freshBatch()), "");
  assert.equal(taken([file("readme.txt")])[1][0].state, "error");
});

test("no more files and bytes are taken than may be sent", () => {
  const [, many] = taken(Array.from({ length: 6 }, (_, k) => file(`${k}.bvh`)));
  assert.deepEqual(many.map((item) => item.state), ["waiting", "waiting", "waiting", "waiting", "error", "error"]);
  const [, large] = taken([file("a.bvh", 1000), file("b.bvh", 1000), file("c.bvh", 1000), file("d.bvh", 400)]);
  assert.deepEqual(large.map((item) => item.state), ["waiting", "waiting", "error", "waiting"]);
});

test("the same file twice is one; another of the same name gets a folder of its own", () => {
  const [batch] = taken([file("a.bvh"), file("a.bvh"), file("a.bvh", 101)]);
  assert.deepEqual(batch.items.map((item) => item.path), ["a.bvh", "2/a.bvh"]);
});

test("a data set is called after its folder, or after its only file", () => {
  assert.equal(taken([file("walks/a.bvh"), file("walks/b.bvh")])[0].name, "walks");
  assert.equal(taken([file("a.bvh"), file("b.bvh")])[0].name, "Recordings");
  assert.equal(taken([file("run 3.amc.gz")])[0].name, "run 3");
  assert.equal(taken([file("notes.pdf"), file("run.bvh")])[0].name, "run");
  assert.equal(taken([file("scene.fbx")])[0].name, "");
});

test("the dialog asks for what has come, without what was left out", () => {
  const [batch] = taken([file("a.amc"), file("a.asf"), file("b.bvh"), file("labels.csv"), file("big.bvh", 9999)]);
  assert.deepEqual(kinds(batch), { recordings: 2, labels: 1, amc: 1, archives: 0 });
});

test("files that may hold anything are what the server found in them", () => {
  const [batch] = taken([file("a.csv"), file("b.csv")]);
  batch.items[0].recording = true;
  assert.deepEqual(kinds(batch), { recordings: 1, labels: 1, amc: 0, archives: 0 });
});

test("sizes read as people say them", () => {
  assert.deepEqual([1, 5000, 3 * 2 ** 20, 2.5 * 2 ** 30].map(sizeInWords), ["1 kB", "5 kB", "3.0 MB", "2.5 GB"]);
});
