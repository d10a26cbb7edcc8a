import assert from "node:assert/strict";
import test from "node:test";
import { deflateSync } from "node:zlib";
import { inflate, positionsOf } from "../../../assets/report/packed_motion.mjs";

test("second differences that wrap around come back as positions", async () => {
  const columns = [[10, 12, 13], [32000, -32000, 0], [5, 5, 5]]; // one joint, three frames
  const differences = columns.flatMap((column) => {
    const slopes = column.map((value, k) => value - (column[k - 1] ?? 0));
    return slopes.map((slope, k) => ((slope - (slopes[k - 1] ?? 0)) << 16) >> 16);
  });
  const numbers = await inflate(deflateSync(Buffer.from(Int16Array.from(differences).buffer)).toString("base64"));
  assert.deepEqual([...numbers], differences);
  const piece = { clip: "a", start: 0, end: 3, step: 1, frames: 3, unit: 0.5, origin: [1, 0, 0] };
  assert.deepEqual([...positionsOf(numbers, 0, piece, 1)], [6, 16000, 2.5, 7, -16000, 2.5, 7.5, 0, 2.5]);
});
