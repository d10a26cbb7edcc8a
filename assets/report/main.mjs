// A report: blocks that can be explored and a small player beside them, from one file without a server.
import { Player } from "../blocks/player.mjs";
import { drawBlock } from "../blocks/registry.mjs";
import { lightBlocks } from "../blocks/selection.mjs";
import { element, targetOf, within } from "../shared/dom.mjs";
import { clock, plural } from "../shared/words.mjs";
import "./blocks.mjs";
import { PackedMotion } from "./packed_motion.mjs";
/** @import { Context, Drawn, Playing } from "../blocks/types.d.ts" */
/** @import { Report } from "./types.d.ts" */

const root = document.documentElement;

/** @param {string} name */
const data = (name) => within(document, `script[data-part="${name}"]`).textContent ?? "";

/** The place with the player: shows what was chosen, or says that it is not in the file. @param {PackedMotion} packed */
function makePlayer(packed) {
  const place = within(document, ".report-player");
  const canvas = element("canvas", "report-canvas");
  canvas.tabIndex = 0;
  canvas.setAttribute("aria-label", "Figures in motion: drag to turn, space to stop");
  const title = element("h2", "report-playing", "Click a motif, a place on the map or a clip: it plays here.");
  const [button, bar, time] = [element("button", "", "Pause"), element("input"), element("span", "number muted")];
  const side = element("button", "", "Side by side");
  const close = element("button", "report-close", "×");
  Object.assign(bar, { type: "range", min: "0", max: "1000", value: "0" });
  bar.setAttribute("aria-label", "Moment");
  close.title = "Close";
  const note = element("p", "muted report-note");
  place.append(element("div", "report-head", title, close), canvas, element("div", "report-bar", button, bar, time, side), note);
  const player = new Player(canvas);
  player.onFrame = () => {
    const { time: now, duration, playing } = player.clock;
    bar.value = String(duration ? (1000 * now) / duration : 0);
    time.textContent = `${clock(now)} / ${clock(duration)}`;
    button.textContent = playing ? "Pause" : "Play";
  };
  button.addEventListener("click", () => player.toggle());
  bar.addEventListener("input", (event) => {
    player.clock.playing = false;
    player.seek(Number(targetOf(event).value) / 1000);
  });
  side.addEventListener("click", () => {
    player.lay(player.layout === "overlay" ? "side" : "overlay");
    side.textContent = player.layout === "overlay" ? "Side by side" : "Overlay";
  });
  close.addEventListener("click", () => root.classList.remove("playing"));
  /** @param {Playing} playing */
  const show = async (playing) => {
    root.classList.add("playing");
    const figures = await packed.figures(playing.items);
    title.textContent = playing.title;
    const missing = playing.items.length - figures.length;
    note.textContent = missing ? `${plural(missing, "motion is", "motions are")} not in this file.` : "";
    side.hidden = figures.length < 2;
    player.show(figures);
  };
  return { player, show };
}

function start() {
  /** @type {Report} */
  const report = JSON.parse(data("report"));
  const packed = new PackedMotion(report.motion, data("motion"));
  const { player, show } = makePlayer(packed);
  /** @type {Drawn[]} */
  const drawn = [];
  /** @type {Context} */
  const context = {
    select(selection, playing) {
      lightBlocks(drawn.map((block) => ({ drawn: block, same: true })), selection);
      if (playing) show(playing);
    },
    figures: (items) => packed.figures(items),
    opens: false,
    dark: () => root.dataset.mantineColorScheme === "dark",
  };
  const main = within(document, ".report-blocks");
  for (const part of report.parts) {
    const body = element("div", "report-body");
    const section = element("section", "report-part", part.title && element("h2", "", part.title), part.note && element("p", "muted", part.note), body);
    section.style.setProperty("--columns", String(part.columns));
    main.append(section);
    drawn.push(drawBlock(body, part.kind, part.content, context));
  }
  const looks = within(document, ".report-scheme");
  /** @param {boolean} dark */
  const paint = (dark) => {
    root.dataset.mantineColorScheme = dark ? "dark" : "light";
    looks.textContent = dark ? "Light" : "Dark";
    for (const block of drawn) block.recolour?.();
    player.recolour();
  };
  looks.addEventListener("click", () => paint(!context.dark()));
  window.addEventListener("beforeprint", () => {
    if (context.dark()) paint(false);
  });
  paint(matchMedia("(prefers-color-scheme: dark)").matches);
  root.dataset.ready = "yes";
  globalThis.motionscape = { player, packed, select: context.select };
}

start();
