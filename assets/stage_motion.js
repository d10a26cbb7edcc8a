// Motions from the server: fetched as binary, kept in a bounded cache, shared between requests.
(function (parts) {
  "use strict";

  const CACHE_BYTES = 96 * 1024 * 1024;

  function motionUrl(api, { dataset, version }, item) {
    const interval = new URLSearchParams();
    if (version) interval.set("v", version);
    if (item.start != null) interval.set("start", item.start);
    if (item.end != null) interval.set("end", item.end);
    const query = interval.toString();
    return `${api}/motion/${encodeURIComponent(dataset)}/${encodeURIComponent(item.clip)}${query ? "?" + query : ""}`;
  }

  /** uint32 header length, JSON header, float32 positions (frames, joints, 3): see docs/architecture.md. */
  function decode(buffer) {
    const length = new DataView(buffer).getUint32(0, true);
    const header = JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 4, length)));
    const positions = new Float32Array(buffer, 4 + length, header.frames * header.joints.length * 3);
    return { header, positions, bytes: buffer.byteLength };
  }

  async function ask(url, signal) {
    let response;
    try {
      response = await fetch(url, { signal });
    } catch (error) {
      if (error.name === "AbortError") throw error;
      throw new Error("The server cannot be reached. Is Motionscape still running?");
    }
    if (response.ok) return response;
    const answer = await response.json().catch(() => ({}));
    throw new Error(answer.error || `The server answered with an error (${response.status}).`);
  }

  /** Least recently used motions are dropped once the rest exceeds the limit. */
  class MotionCache {
    constructor(limit = CACHE_BYTES) {
      this.limit = limit;
      this.bytes = 0;
      this.motions = new Map();
    }

    /**
     * The motion at a URL. A data set's name may come to stand for other content, so the server is asked whether the
     * motion still holds, unless the URL names the content (`forGood`).
     */
    async get(url, signal, forGood) {
      const known = this.motions.get(url);
      if (known && forGood) return this.keep(url, known);
      const response = await ask(url, signal);
      const tag = response.headers.get("ETag");
      if (known && tag && known.tag === tag) {
        response.body?.cancel();
        return this.keep(url, known);
      }
      return this.keep(url, { tag, ...decode(await response.arrayBuffer()) });
    }

    keep(url, motion) {
      this.bytes += motion.bytes - (this.motions.get(url)?.bytes ?? 0);
      this.motions.delete(url);
      this.motions.set(url, motion);
      for (const [oldest, { bytes }] of this.motions) {
        if (this.bytes <= this.limit || oldest === url) break;
        this.motions.delete(oldest);
        this.bytes -= bytes;
      }
      return motion;
    }
  }

  parts.motionUrl = motionUrl;
  parts.MotionCache = MotionCache;
})((window.motionscapeStageParts ||= {}));
