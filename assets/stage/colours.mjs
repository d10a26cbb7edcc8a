// Colours: read from CSS variables, mixed and cached as strings so that nothing is built while drawing.
import { context2d } from "../shared/dom.mjs";
/** @import { Rgb, Theme } from "./types.d.ts" */

export const FOG_LEVELS = 8;
const VARIABLES = ["sky", "haze", "floor", "rim", "grid", "shadow", "contact", "left", "right", "spine", "text", "muted", "accent"];
// hue (degrees) and lightness steps in OKLCH; neighbours differ in both, so that they stay apart for the colour-blind
const HUES = [255, 55, 155, 330, 95, 205, 25, 285, 125, 0, 230, 75];
const LIFTS = [0, 0.02, -0.02, 0.03, 0.05, 0.06, -0.05, -0.03, 0.04, -0.06, 0.08, -0.02];

/** @type {CanvasRenderingContext2D | null} */
let scratch = null; // made when the first colour is read

/**
 * [r, g, b] of any CSS colour; grey where it is none.
 * @param {string} colour
 */
export function parseColour(colour) {
  scratch ??= document.createElement("canvas").getContext("2d", { willReadFrequently: true });
  if (!scratch) return [128, 128, 128];
  scratch.fillStyle = "#808080";
  scratch.fillStyle = colour;
  scratch.clearRect(0, 0, 1, 1);
  scratch.fillRect(0, 0, 1, 1);
  return Array.from(scratch.getImageData(0, 0, 1, 1).data.slice(0, 3));
}

/** @param {Rgb} a @param {Rgb} b @param {number} share */
export const mix = (a, b, share) => a.map((value, k) => value + (b[k] - value) * share);
/** @param {Rgb} rgb */
export const css = (rgb) => `rgb(${rgb.map((v) => Math.round(Math.min(Math.max(v, 0), 255))).join(",")})`;

/**
 * OKLCH to [r, g, b], 0-255 (Ottosson 2020).
 * @param {number} lightness
 * @param {number} chroma
 * @param {number} degrees
 */
function oklch(lightness, chroma, degrees) {
  const [a, b] = [chroma * Math.cos((degrees * Math.PI) / 180), chroma * Math.sin((degrees * Math.PI) / 180)];
  const l = (lightness + 0.3963377774 * a + 0.2158037573 * b) ** 3;
  const m = (lightness - 0.1055613458 * a - 0.0638541728 * b) ** 3;
  const s = (lightness - 0.0894841775 * a - 1.291485548 * b) ** 3;
  const linear = [
    4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
    -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
    -0.0041960863 * l - 0.7034186147 * m + 1.707614701 * s,
  ];
  return linear.map((v) => 255 * (v <= 0.0031308 ? 12.92 * v : 1.055 * v ** (1 / 2.4) - 0.055));
}

/**
 * The theme's colours as [r, g, b], from --ms-stage-* variables of an element.
 * @param {Element} element
 */
export function readTheme(element) {
  const style = getComputedStyle(element);
  /** @type {any} */
  const theme = {};
  for (const name of VARIABLES) theme[name] = parseColour(style.getPropertyValue(`--ms-stage-${name}`).trim());
  theme.dark = theme.sky[0] + theme.sky[1] + theme.sky[2] < 384;
  theme.font = style.fontFamily;
  return /** @type {Theme} */ (theme);
}

/**
 * Three colours (left, right, spine) of figure k of n.
 * @param {Theme} theme
 * @param {number} k
 * @param {number} n
 * @param {string | undefined} own
 */
export function figureColours(theme, k, n, own) {
  if (own) {
    const base = parseColour(own);
    return [mix(base, [255, 255, 255], 0.25), mix(base, [0, 0, 0], 0.25), base];
  }
  if (n === 1) return [theme.left, theme.right, theme.spine];
  const [hue, round] = [HUES[k % HUES.length], Math.floor(k / HUES.length)];
  const lightness = (theme.dark ? 0.7 : 0.6) + LIFTS[k % LIFTS.length] - 0.09 * (round % 3);
  return [0.085, -0.085, 0].map((lift) => oklch(lightness + lift, theme.dark ? 0.125 : 0.135, hue + 15 * round));
}

/**
 * Strings for every depth: `fill[side][level]`, darker `edge`, lighter `sheen` and `light`. Level 0 is nearest.
 * @param {Theme} theme
 * @param {Rgb[]} colours
 * @param {number} fade
 */
export function shades(theme, colours, fade) {
  /** @param {(rgb: Rgb) => Rgb} change */
  const levels = (change) =>
    colours.map((rgb) => Array.from({ length: FOG_LEVELS }, (_, level) =>
      css(mix(change(rgb), theme.haze, fade + (1 - fade) * 0.4 * (level / (FOG_LEVELS - 1))))));
  /** @type {HTMLCanvasElement[]} */
  const balls = [];
  return {
    /** @param {number} level */
    ball: (level) => (balls[level] ??= ball(theme, colours[2], fade + (1 - fade) * 0.4 * (level / (FOG_LEVELS - 1)))),
    fill: levels((rgb) => rgb),
    edge: levels((rgb) => mix(rgb, theme.dark ? [8, 10, 14] : [20, 24, 32], theme.dark ? 0.62 : 0.42)),
    sheen: levels((rgb) => mix(rgb, [255, 255, 255], theme.dark ? 0.1 : 0.13)),
    light: levels((rgb) => mix(rgb, [255, 255, 255], theme.dark ? 0.26 : 0.36)),
  };
}

/**
 * A shaded ball, drawn once and then only copied.
 * @param {Theme} theme
 * @param {Rgb} rgb
 * @param {number} fog
 */
function ball(theme, rgb, fog) {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = 96;
  const context = context2d(canvas);
  const gradient = context.createRadialGradient(34, 30, 4, 44, 42, 56);
  /** @param {Rgb} colour */
  const fogged = (colour) => css(mix(colour, theme.haze, fog));
  gradient.addColorStop(0, fogged(mix(rgb, [255, 255, 255], 0.42)));
  gradient.addColorStop(0.5, fogged(rgb));
  gradient.addColorStop(1, fogged(mix(rgb, [0, 0, 0], 0.22)));
  context.fillStyle = gradient;
  context.beginPath();
  context.arc(48, 48, 48, 0, 2 * Math.PI);
  context.fill();
  return canvas;
}

