// What an open board asks for, asked for as soon as the script of a page runs whose address names a board: the answers
// have come when Dash has drawn the page.
import { ask } from "../shared/server.mjs";
import { gridstack } from "./grid.mjs";
/** @import { Board } from "./types.d.ts" */

const FRESH = 10_000; // milliseconds after which what has not been taken is asked again

/** @type {Map<string, Promise<any>>} */
const asked = new Map();

/** The answer that was asked for ahead, once; else it is asked for now. @param {string} path */
export function take(path) {
  const answer = asked.get(path);
  asked.delete(path);
  return answer ?? ask(path);
}

/** @param {string} path */
function begin(path) {
  const answer = ask(path);
  answer.catch(() => {}); // whoever takes it hears of it
  asked.set(path, answer);
  return answer;
}

/** @param {string} board */
async function beginBoard(board) {
  begin("boards");
  gridstack().catch(() => {});
  const { blocks } = /** @type {Board} */ (await begin(`boards/${board}`));
  for (const { id } of blocks) begin(`boards/${board}/blocks/${id}`);
}

const board = new URLSearchParams(location.search).get("board") ?? "";
if (location.pathname.endsWith("/boards") && /^[\w-]+$/.test(board)) {
  beginBoard(board).catch(() => {});
  setTimeout(() => asked.clear(), FRESH);
}
