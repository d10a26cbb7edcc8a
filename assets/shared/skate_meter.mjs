// How far feet slide in motion that was made, held against the recordings it was made of.
import { element } from "./dom.mjs";

/**
 * skate: metres a second that standing feet slide, in the recordings, after blending alone, and in what was made; speeds: of
 * the fastest joint in the blends and in the recordings, in metres a second; jump: whether a blend is too fast.
 * @typedef {{ skate?: [number, number, number], speeds: [number, number], jump: boolean }} Quality
 */

/**
 * Draw the meter into its box; nothing is shown where nothing was made.
 * @param {HTMLElement} box
 * @param {string} label
 * @param {Quality | null} quality
 * @param {boolean} [blended]
 */
export function drawSkateMeter(box, label, quality, blended = true) {
  box.classList.toggle("hidden", !quality?.skate);
  if (!quality?.skate) return;
  const [source, plain, kept] = quality.skate;
  const most = Math.max(source, plain, kept, 1e-6);
  const title = element("div", "walk-meter-title", "Foot skate");
  title.title = "How far standing feet slide, in centimetres per second of contact";
  /** @type {[string, number][]} */
  const rows = [[label, kept], ["Blending alone", plain], ["Recordings", source]];
  const meters = rows.map(([name, value], i) => {
    const bar = element("span", "walk-bar");
    bar.style.setProperty("--share", String(value / most));
    const number = element("span", "number", `${(100 * value).toFixed(1)} cm/s`);
    return element("div", i ? "walk-meter" : "walk-meter walk-meter-own", element("span", "", name), bar, number);
  });
  const [blends, recordings] = quality.speeds;
  const words = blended
    ? `${quality.jump ? "A blend jumps" : "No jump"}: fastest joint ${blends} m/s in the blends, ${recordings} m/s in the recordings.`
    : "Recorded as it is: nothing had to be blended.";
  box.replaceChildren(title, ...meters, element("div", quality.jump ? "walk-speed walk-jump" : "walk-speed", words));
}
