import assert from "node:assert/strict";
import { afterEach, test } from "node:test";
import { MotionCache } from "../../../assets/stage/motion.mjs";

const text = new TextEncoder();
const fetchOfNode = globalThis.fetch;
afterEach(() => (globalThis.fetch = fetchOfNode));

function packed(header, body) {
  const json = text.encode(JSON.stringify(header).padEnd(Math.ceil(JSON.stringify(header).length / 4) * 4));
  const bytes = new Uint8Array(4 + json.length + body.length);
  new DataView(bytes.buffer).setUint32(0, json.length, true);
  bytes.set(json, 4);
  bytes.set(body, 4 + json.length);
  return bytes;
}

/** A server that answers for any clip; those called "bad" are refused, each motion has one frame of one joint. */
function serve(asked) {
  globalThis.fetch = async (address) => {
    asked.push(address);
    const query = new URL(address, "http://here").searchParams;
    const parts = query.getAll("clip").map((clip) => clip === "bad" ? { error: "no such clip" }
      : packed({ clip, frames: 1, joints: ["hips"] }, new Uint8Array(new Float32Array([1, 2, 3]).buffer)));
    const told = parts.map((part) => part instanceof Uint8Array ? { bytes: part.length } : part);
    const body = Uint8Array.from(parts.filter((part) => part instanceof Uint8Array).flatMap((part) => [...part]));
    return new Response(packed({ parts: told }, body));
  };
}

test("motions come in the order of their items, each as itself or as an error in plain words", async () => {
  const asked = [];
  serve(asked);
  const motions = await new MotionCache().load("/api", { dataset: "d" }, [{ clip: "a" }, { clip: "bad" }, { clip: "b" }]);
  assert.deepEqual([motions[0].header.clip, motions[1].message, motions[2].header.clip], ["a", "no such clip", "b"]);
  assert.deepEqual([...motions[2].positions], [1, 2, 3]);
  assert.equal(asked.length, 1);
});

test("what has a version is asked for once, what has none again", async () => {
  const asked = [];
  serve(asked);
  const cache = new MotionCache();
  for (let k = 0; k < 2; k++) await cache.load("/api", { dataset: "d", version: "1" }, [{ clip: "a", start: 0, end: 5 }]);
  assert.equal(asked.length, 1);
  for (let k = 0; k < 2; k++) await cache.load("/api", { dataset: "d" }, [{ clip: "a", start: 0, end: 5 }]);
  assert.equal(asked.length, 3);
  await Promise.all([0, 1].map(() => cache.load("/api", { dataset: "~made~1" }, [{ clip: "a" }])));
  assert.equal(asked.length, 4);
});

test("long lists are asked for in several addresses that proxies take", async () => {
  const asked = [];
  serve(asked);
  const items = Array.from({ length: 400 }, (_, k) => ({ clip: `a clip with a rather long name, number ${k}`, start: k, end: k + 9 }));
  const motions = await new MotionCache().load("/api", { dataset: "d" }, items);
  assert.deepEqual(motions.map((motion) => motion.header.clip), items.map((item) => item.clip));
  assert.ok(asked.length > 1 && asked.every((address) => address.length <= 6000));
});

test("the cache forgets what was used longest ago", async () => {
  serve([]);
  const cache = new MotionCache(1);
  await cache.load("/api", { dataset: "d", version: "1" }, [{ clip: "a" }, { clip: "b" }]);
  assert.equal(cache.motions.size, 1);
  assert.equal([...cache.motions.values()][0].header.clip, "b");
});

test("a server that is away is an error in plain words", async () => {
  globalThis.fetch = async () => { throw new TypeError("network"); };
  const [motion] = await new MotionCache().load("/api", { dataset: "d" }, [{ clip: "a" }]);
  assert.match(motion.message, /cannot be reached/);
});
