// The warp strip: one row a motion, along the medoid's time; colour tells where it is slower or faster than the medoid.
(function (parts) {
  "use strict";

  const [SLOW, FAST] = [[33, 102, 172], [230, 97, 1]];
  const RANGE = Math.log(2.5); // colours are full where a motion runs 2.5 times as fast or as slow

  class WarpStrip {
    constructor(holder) {
      this.holder = holder;
      this.canvas = holder.querySelector("canvas");
      this.cursor = holder.querySelector(".ms-warp-cursor");
      this.speeds = [];
    }

    /** Smoothed speed of each motion relative to the medoid's, one value a medoid frame; none hides the strip. */
    show(figures, timeline) {
      this.speeds = timeline.warped ? figures.filter((f) => f.warp && f.visible).map((f) => localSpeed(f, figures[timeline.reference])) : [];
      this.holder.hidden = this.speeds.length < 2;
      if (!this.holder.hidden) this.figures = figures.filter((f) => f.warp && f.visible);
      return !this.holder.hidden;
    }

    paint(theme) {
      if (this.holder.hidden) return;
      const rows = this.speeds.length;
      const height = Math.max(3, Math.min(9, Math.floor(84 / rows)));
      this.canvas.style.height = `${rows * (height + 1)}px`;
      const ratio = Math.min(window.devicePixelRatio || 1, 2);
      const width = Math.max(1, Math.round(this.canvas.clientWidth * ratio));
      this.canvas.width = width;
      this.canvas.height = Math.round(rows * (height + 1) * ratio);
      const context = this.canvas.getContext("2d");
      const neutral = parts.mix(theme.haze, theme.muted, 0.3);
      const columns = Math.min(width, 400);
      this.speeds.forEach((speed, row) => {
        const y = Math.round(row * (height + 1) * ratio);
        for (let c = 0; c < columns; c++) {
          const s = Math.log(Math.max(speed[Math.floor(((c + 0.5) * speed.length) / columns)], 0.05)) / RANGE;
          context.fillStyle = parts.css(parts.mix(neutral, s < 0 ? SLOW : FAST, Math.min(Math.abs(s), 1)));
          context.fillRect(Math.floor((c * width) / columns), y, Math.ceil(width / columns) + 1, Math.round(height * ratio));
        }
        context.fillStyle = this.figures[row].shades.fill[2][0];
        context.fillRect(0, y, Math.round(4 * ratio), Math.round(height * ratio));
      });
    }

    place(share) {
      if (!this.holder.hidden) this.cursor.style.left = `${(100 * share).toFixed(3)}%`;
    }

    /** What the row and column under the pointer mean, in words. */
    describe(event) {
      const box = this.canvas.getBoundingClientRect();
      const row = Math.floor(((event.clientY - box.top) / box.height) * this.speeds.length);
      const share = (event.clientX - box.left) / box.width;
      const speed = this.speeds[row]?.[Math.floor(share * this.speeds[row].length)];
      if (!(speed > 0)) return "";
      const pace = speed > 1.05 ? `${speed.toFixed(1)}× as fast` : speed < 0.95 ? `${(1 / speed).toFixed(1)}× as slow` : "as fast";
      return `${this.figures[row].label}: ${pace} as the middle motion here. Click to go there.`;
    }
  }

  function localSpeed(figure, medoid) {
    const { warp } = figure;
    const reach = Math.max(1, Math.round(0.1 * medoid.ownFps));
    return Float32Array.from(warp, (_, k) => {
      const [a, b] = [Math.max(k - reach, 0), Math.min(k + reach, warp.length - 1)];
      return ((warp[b] - warp[a]) / (b - a)) * (medoid.ownFps / figure.ownFps);
    });
  }

  parts.WarpStrip = WarpStrip;
})((window.motionscapeStageParts ||= {}));
