// A film: paints one motion frame by frame and sends each picture to the process that writes it (webapp/stage/film.py).
import { Player } from "../blocks/player.mjs";
import { within } from "../shared/dom.mjs";
import { Figure } from "../stage/figure.mjs";
import { decode } from "../stage/motion.mjs";

/** @typedef {{ first: number, frames: number, rate: number, width: number, height: number, yaw: number, pitch: number, theme: string }} Film */

/** @param {string} place @param {BodyInit} body */
async function send(place, body) {
  const answer = await fetch(place, { method: "POST", body });
  if (!answer.ok) throw new Error(`${place}: ${answer.status}`);
}

/** @param {Film} film */
async function paint(film) {
  document.documentElement.dataset.mantineColorScheme = film.theme;
  const canvas = document.createElement("canvas");
  Object.assign(canvas.style, { width: `${film.width}px`, height: `${film.height}px`, display: "block" });
  document.body.append(canvas);
  const motion = decode(await (await fetch("motion")).arrayBuffer());
  const player = new Player(canvas);
  player.close(); // it does not run by itself: every frame is painted here
  player.show([new Figure({ clip: motion.header.clip, label: "" }, motion, 0)]);
  player.camera.reset(film);
  player.fit();
  for (let k = 0; k < film.frames; k++) {
    player.clock.time = Math.min((film.first + k) / film.rate, player.clock.duration);
    player.paint(1 / film.rate);
    await send(`frame/${k}`, player.scene.context.getImageData(0, 0, film.width, film.height).data);
  }
}

paint(JSON.parse(within(document, "script[data-film]").textContent ?? "")).catch((error) => send("error", String(error)));
