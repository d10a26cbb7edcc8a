// Watches what changes how the Stage looks: its size, and the page's theme.
/** @import { Stage } from "./stage.mjs" */

export class Looks {
  /** @param {Stage} stage */
  constructor(stage) {
    this.size = new ResizeObserver(() => stage.resized());
    this.size.observe(stage.scene.canvas);
    this.theme = new MutationObserver(() => stage.readLooks());
    for (const node of [document.documentElement, document.body]) {
      this.theme.observe(node, { attributes: true, attributeFilter: ["data-mantine-color-scheme", "class", "style"] });
    }
  }

  close() {
    this.size.disconnect();
    this.theme.disconnect();
  }
}
