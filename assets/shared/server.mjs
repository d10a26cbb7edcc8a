// What the page asks the server, and under which name someone works where there are no accounts.

const NAME = "motionscape-name";

/** An answer that is no success; `answer` is what the server said. */
export class Refused extends Error {
  /** @param {number} status @param {any} answer */
  constructor(status, answer) {
    super(answer?.error || `The server answered with an error (${status}).`);
    this.status = status;
    this.answer = answer ?? {};
  }
}

/** The name that comments and changes get where the server knows none. */
export const person = {
  get name() { return localStorage.getItem(NAME) ?? ""; },
  set name(name) { localStorage.setItem(NAME, name.trim().slice(0, 80)); },
};

/**
 * JSON from the server. Throws Refused, or an Error where it cannot be reached.
 * @param {string} path
 * @param {Record<string, any>} [body] sent with POST where it is given
 * @param {string} [mark] of what is known already: null comes back where nothing has changed
 */
export async function ask(path, body, mark = "") {
  /** @type {RequestInit} */
  const options = body
    ? { method: "POST", headers: { "Content-Type": "application/json", "X-Motionscape": "boards" }, body: JSON.stringify({ author: person.name, ...body }) }
    : { headers: mark ? { "If-None-Match": mark } : {}, cache: mark ? "no-store" : "no-cache" };
  const answer = await fetch(`/api/${path}`, options).catch(() => {
    throw new Error("The server cannot be reached. Is Motionscape still running?");
  });
  if (answer.status === 304) return null;
  const content = await answer.json().catch(() => null);
  if (!answer.ok) throw new Refused(answer.status, content);
  if (content && !body && answer.headers.get("ETag")) content.etag = answer.headers.get("ETag");
  return content;
}
