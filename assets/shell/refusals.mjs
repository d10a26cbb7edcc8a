// Says in words when the server no longer knows who one is, or refuses what one may not do; requests go on as they are.
import { notify } from "../shared/dash.mjs";

const QUIET = 10_000; // milliseconds in which the same is not said again
/** @type {Map<number, number>} */
const said = new Map();

/**
 * What to say of an answer: title and text, or null where there is nothing to say.
 * @param {number} status
 * @param {{ title?: unknown, error?: unknown }} body
 * @returns {[string, string] | null}
 */
export function words(status, body) {
  if (typeof body.error !== "string") return null;
  const title = typeof body.title === "string" ? body.title : "You may not do this";
  if (status === 401) return [title, `${body.error} Reload the page to sign in; what you see stays until then.`];
  return status === 403 ? [title, body.error] : null;
}

/** @param {Response} answer */
async function tell(answer) {
  const body = await answer.json().catch(() => ({}));
  const now = Date.now();
  if (now - (said.get(answer.status) ?? -QUIET) < QUIET) return;
  const text = words(answer.status, body ?? {});
  if (!text) return;
  said.set(answer.status, now);
  notify(text[0], text[1], "red");
}

/** Listens to the answers that all other modules and Dash get. */
function listen() {
  const send = window.fetch;
  window.fetch = async (address, options) => {
    const answer = await send.call(window, address, options);
    if ((answer.status === 401 || answer.status === 403) && new URL(answer.url, location.href).origin === location.origin) void tell(answer.clone());
    return answer;
  };
}

if (typeof window !== "undefined") listen();
