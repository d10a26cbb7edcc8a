// Motions from the server: asked for together, fetched as binary, kept in a bounded cache, shared between requests.
/** @import { Item, Motion, Segment, StageRequest } from "./types.d.ts" */

const CACHE_BYTES = 96 * 1024 * 1024;
/** @type {[string, "dataset" | "version" | "clip" | "start" | "end"][]} */
const COLUMNS = [["dataset", "dataset"], ["v", "version"], ["clip", "clip"], ["start", "start"], ["end", "end"]]; // of an address, and what they hold
const LONGEST_ADDRESS = 6000; // letters; proxies refuse more than eight thousand

/**
 * Which segment an item stands for; its own data set and version count before the request's.
 * @param {StageRequest} request
 * @param {Item} item
 */
function segmentOf(request, item) {
  const dataset = String(item.dataset ?? request.dataset ?? "");
  const version = String(((item.dataset ?? null) === null ? item.version ?? request.version : item.version) ?? "");
  const segment = { dataset, version, clip: String(item.clip), start: item.start ?? "", end: item.end ?? "" };
  // with a version, or a name made from its content, the same segment is the same motion for good
  return { ...segment, key: JSON.stringify(Object.values(segment)), permanent: version !== "" || dataset.startsWith("~") };
}

/**
 * Addresses that ask for all segments, each with its share of them.
 * @param {string} api
 * @param {Segment[]} segments
 * @returns {[string, Segment[]][]}
 */
function addresses(api, segments) {
  const query = new URLSearchParams();
  /** @param {string} name @param {string[]} values */
  const column = (name, values) => new Set(values).size === 1 && name !== "clip" ? query.set(name, values[0]) : values.forEach((value) => query.append(name, value));
  for (const [name, key] of COLUMNS) {
    column(name, segments.map((segment) => String(segment[key])));
  }
  const address = `${api}/motions?${query}`;
  if (address.length <= LONGEST_ADDRESS || segments.length === 1) return [[address, segments]];
  const half = segments.length >> 1;
  return [...addresses(api, segments.slice(0, half)), ...addresses(api, segments.slice(half))];
}

/**
 * uint32 header length, JSON header: the header, and where what follows begins.
 * @param {ArrayBuffer} buffer
 */
function readHeader(buffer) {
  const length = new DataView(buffer).getUint32(0, true);
  return [JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 4, length))), 4 + length];
}

/**
 * float32 positions (frames, joints, 3) after their header: see docs/reference/stage.md.
 * @param {ArrayBuffer} buffer
 */
export function decode(buffer) {
  const [header, at] = readHeader(buffer);
  return { header, positions: new Float32Array(buffer, at, header.frames * header.joints.length * 3), bytes: buffer.byteLength };
}

/**
 * Each part a motion or an Error; copies, so that one that is kept does not keep them all.
 * @param {ArrayBuffer} buffer
 */
function decodeParts(buffer) {
  const [{ parts }, begin] = readHeader(buffer);
  let at = begin;
  return parts.map(/** @param {{ error?: string, bytes: number }} part */ ({ error, bytes }) => {
    if (error) return new Error(error);
    at += bytes;
    return decode(buffer.slice(at - bytes, at));
  });
}

/** @param {string} url */
async function ask(url) {
  let response;
  try {
    response = await fetch(url);
  } catch {
    throw new Error("The server cannot be reached. Is Motionscape still running?");
  }
  if (response.ok) return decodeParts(await response.arrayBuffer());
  const answer = await response.json().catch(() => ({}));
  throw new Error(answer.error || `The server answered with an error (${response.status}).`);
}

/** Least recently used motions are dropped once the rest exceeds the limit. */
export class MotionCache {
  /** @param {number} [limit] */
  constructor(limit = CACHE_BYTES) {
    this.limit = limit;
    this.bytes = 0;
    /** @type {Map<string, Motion>} */
    this.motions = new Map();
    /** @type {Map<string, Promise<Motion | Error>>} */
    this.coming = new Map(); // key -> promise, so that who asks again meanwhile waits for the same answer
  }

  /**
   * The motions of a request's items, in their order: each a motion or an Error in plain words. Never rejects. A data
   * set's name may come to stand for other content, so the server is asked again unless the segment is for good.
   * @param {string} api
   * @param {StageRequest} request
   * @param {Item[]} items
   */
  load(api, request, items) {
    const segments = items.map((item) => segmentOf(request, item));
    const wanted = new Map();
    for (const segment of segments) {
      const { key, permanent } = segment;
      if (permanent && (this.motions.has(key) || this.coming.has(key))) continue;
      wanted.set(key, segment);
    }
    if (wanted.size) this.fetch(addresses(api, [...wanted.values()]));
    return Promise.all(segments.map(({ key }) => this.coming.get(key) ?? this.keep(key, /** @type {Motion} */ (this.motions.get(key)))));
  }

  /** @param {[string, Segment[]][]} batches */
  fetch(batches) {
    for (const [address, segments] of batches) {
      const answer = ask(address).catch((error) => segments.map(() => error));
      segments.forEach(({ key }, k) => {
        const motion = answer.then((motions) => {
          if (this.coming.get(key) === motion) this.coming.delete(key);
          return motions[k] instanceof Error ? motions[k] : this.keep(key, motions[k]);
        });
        this.coming.set(key, motion);
      });
    }
  }

  /** @param {string} key @param {Motion} motion */
  keep(key, motion) {
    this.bytes += motion.bytes - (this.motions.get(key)?.bytes ?? 0);
    this.motions.delete(key);
    this.motions.set(key, motion);
    for (const [oldest, { bytes }] of this.motions) {
      if (this.bytes <= this.limit || oldest === key) break;
      this.motions.delete(oldest);
      this.bytes -= bytes;
    }
    return motion;
  }
}
