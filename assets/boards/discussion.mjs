// "Comments" in the header: what is said about the motif or the clip that is selected, with moments that play.
import { clientside, register } from "../shared/dash.mjs";
import { closest, find } from "../shared/dom.mjs";
import { button } from "../shared/dialogs.mjs";
import { ask } from "../shared/server.mjs";
import { player } from "../stage/player.mjs";
import { Comments } from "./comments.mjs";
import { COMMENTS_BUTTON } from "./ids.mjs";
/** @import { Board, CommentData, Discussion } from "./types.d.ts" */

const EVERY = 2000; // milliseconds between two questions while the panel is open
const SETTLED = 400; // milliseconds after another selection until its comments are counted

class Panel extends Comments {
  constructor() {
    super(() => this.update());
    this.node.classList.add("discussion");
    /** @type {Discussion | null} */
    this.about = null;
    this.asked = "";
    this.timer = 0;
  }

  place() {
    const { place = "", moments = false } = this.about ?? {};
    return moments ? `${place}/${frameNow(place)}` : place;
  }

  /** @param {CommentData} comment */
  said(comment) {
    const node = super.said(comment);
    if (comment.frame !== undefined) node.prepend(button(`at ${comment.seconds?.toFixed(2)} s`, () => this.seek(Number(comment.frame)), "boards-moment"));
    return node;
  }

  /** @param {number} frame */
  seek(frame) {
    const clip = this.about?.place.replace(/^moment:[^/]+\//, "");
    if (clip) player.seek({ clip, frame });
  }

  /** Ask what is said about what is selected now. */
  async update() {
    const query = location.search;
    const answer = /** @type {Discussion | null} */ (await ask(`comments${query || "?"}`).catch(() => undefined));
    if (query !== location.search || answer === undefined) return;
    const other = answer?.place !== this.about?.place;
    this.about = answer?.place ? answer : null;
    const open = (this.about?.comments ?? []).filter((comment) => !comment.resolved && !comment.parent).length;
    const label = find(COMMENTS_BUTTON);
    if (label) {
      label.hidden = !this.about;
      label.dataset.count = open ? String(open) : "";
      label.title = this.about ? `What is said about ${this.about.title}` : "";
    }
    if (!this.about) this.close();
    else if (!this.node.hidden) {
      if (other) this.open(this.asBoard(), "", this.about.title);
      else this.show(this.asBoard());
    }
  }

  /** What the list of comments needs to know of a board. */
  asBoard() {
    return /** @type {Board} */ (/** @type {unknown} */ ({ ...this.about }));
  }

  poll() {
    clearTimeout(this.timer);
    this.timer = window.setTimeout(async () => {
      if (this.node.hidden) return;
      if (document.visibilityState === "visible") await this.update();
      this.poll();
    }, EVERY);
  }
}

const panel = new Panel();

document.addEventListener("click", async (event) => {
  if (!closest(event, `#${COMMENTS_BUTTON}`)) return;
  if (!panel.node.hidden) {
    panel.close();
    return;
  }
  document.body.append(panel.node);
  await panel.update();
  if (!panel.about) return;
  panel.open(panel.asBoard(), "", panel.about.title);
  panel.poll();
});

let waiting = 0;
register("discussion", {
  // Called with the address, which says what is selected.
  look() {
    const query = location.search.replace(/&?(time|camera|speed|layout)=[^&]*/g, "");
    if (query === panel.asked) return clientside.no_update;
    panel.asked = query;
    clearTimeout(waiting);
    waiting = window.setTimeout(() => panel.update(), SETTLED);
    return clientside.no_update;
  },
});

/** The frame of a clip where the Stage stands; the first where it shows another. @param {string} place */
function frameNow(place) {
  const clip = place.replace(/^moment:[^/]+\//, "");
  for (let k = 0, item; k < 48 && (item = player.frameOf(k)); k++) if (item.clip === clip) return Math.round(item.frame);
  return 0;
}
