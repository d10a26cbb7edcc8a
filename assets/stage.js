// The Stage: a 3D player of stick figures on a 2D canvas. Time comes from the browser; the server is asked for motions
// once. Views call motionscapeStage.show({dataset, version?, items: [{clip, start, end, label, colour?, warp?}], layout?,
// sync?, title?}); version is the data set's fingerprint: with it, known motions are not asked for again.
// This file runs before the other stage_*.js: they fill `parts`, which is used only once the page holds a stage.
(function (parts) {
  "use strict";

  const MOST_FIGURES = 48;
  const STATE_EVERY = 400; // milliseconds between "stage-state" events
  const calm = () => window.matchMedia("(prefers-reduced-motion: reduce)").matches;

  class Stage {
    constructor(root) {
      this.root = root;
      this.clock = new parts.Clock();
      this.camera = new parts.Camera();
      this.traces = new parts.Traces();
      this.scene = new parts.Scene(root.querySelector("#stage-canvas"));
      this.warpStrip = new parts.WarpStrip(root.querySelector(".ms-warp"));
      this.cache = new parts.MotionCache();
      this.figures = [];
      this.timeline = { reference: 0, warped: false, fps: 30, duration: 0 };
      this.layout = "overlay";
      this.sync = "warp";
      this.status = "empty";
      this.followed = [0, 0];
      this.chosen = -1;
      this.fps = 0;
      this.controls = new parts.Controls(this, root);
      this.watchLooks();
      this.setStatus("empty");
      this.frame = (now) => this.tick(now);
      requestAnimationFrame(this.frame);
    }

    /** Follow changes of size, theme and screen. */
    watchLooks() {
      const looks = () => {
        this.scene.setTheme(parts.readTheme(this.root));
        this.colour();
      };
      looks();
      this.observers = [new ResizeObserver(() => this.resized()), new MutationObserver(looks)];
      this.observers[0].observe(this.scene.canvas);
      for (const node of [document.documentElement, document.body]) {
        this.observers[1].observe(node, { attributes: true, attributeFilter: ["data-mantine-color-scheme", "class", "style"] });
      }
    }

    resized() {
      if (this.scene.resize()) this.fit();
      this.warpStrip.paint(this.scene.theme);
      this.draw();
    }

    close() {
      this.closed = true;
      this.abort?.abort();
      this.observers.forEach((observer) => observer.disconnect());
    }

    async show(request) {
      this.abort?.abort();
      this.request = request;
      if (!request?.items?.length) {
        this.clear();
        return this.setStatus("empty");
      }
      const abort = (this.abort = new AbortController());
      const items = request.items.slice(0, MOST_FIGURES);
      this.setStatus("loading", items.length > 1 ? `Loading ${items.length} motions …` : "Loading …");
      const url = (item) => parts.motionUrl(this.root.dataset.api || "/api", request, item);
      const get = (item) => this.cache.get(url(item), abort.signal, Boolean(request.version));
      const answers = await Promise.allSettled(items.map(get));
      if (abort.signal.aborted || this.closed) return undefined;
      const failed = answers.filter((answer) => answer.status === "rejected");
      if (failed.length === items.length) {
        this.clear();
        return this.setStatus("error", failed[0].reason.message);
      }
      this.figures = items.flatMap((item, k) =>
        answers[k].status === "fulfilled" ? [new parts.Figure(item, answers[k].value, k)] : []);
      this.layout = request.layout === "side" ? "side" : "overlay";
      this.sync = request.sync === "start" ? "start" : "warp";
      this.clock.time = 0;
      this.camera.reset(parts.homeView(this.figures, this.layout));
      this.prepare();
      this.setStatus("ready");
      this.notice(request, items, failed);
      this.clock.playing = false;
      if (!calm()) this.clock.play();
      if (this.waiting) this.restore(this.waiting);
      return this.touch(true);
    }

    clear() {
      this.figures = [];
      this.prepare();
    }

    notice(request, items, failed) {
      const missing = failed.length ? `${failed.length} of ${items.length} motions could not be loaded: ${failed[0].reason.message}` : "";
      const cut = request.items.length > items.length ? `Showing ${items.length} of ${request.items.length} motions.` : "";
      const note = this.root.querySelector(".ms-stage-note");
      note.querySelector("span").textContent = [missing, cut].filter(Boolean).join(" ");
      note.hidden = !missing && !cut;
      note.querySelector("button").hidden = !missing;
    }

    retry() {
      this.show(this.request);
    }

    /** Everything that depends on which figures there are, how they are laid out and kept in step. */
    prepare() {
      this.timeline = parts.makeTimeline(this.figures, this.sync);
      this.clock.duration = this.timeline.duration;
      this.clock.seek(this.clock.time);
      this.place();
      this.controls.listFigures();
      this.colour();
      this.warpStrip.show(this.figures, this.timeline);
      this.warpStrip.paint(this.scene.theme);
    }

    place() {
      this.scene.resize();
      parts.placeFigures(this.figures, this.layout, this.scene.width / Math.max(this.scene.height, 1));
      this.scene.bodies.collect(this.figures, this.layout === "overlay");
      this.fit();
      this.clock.jumped = true;
      this.draw();
    }

    /** Frame all figures, unless the person has chosen a distance already. */
    fit() {
      if (!this.figures.length) return;
      const { cloud, radius } = parts.measureStage(this.figures, this.clock.duration);
      this.camera.fit(cloud, this.scene.width / Math.max(this.scene.height, 1));
      this.scene.ground.radius = Math.max(2.2, radius * 1.5 + 0.6);
    }

    colour() {
      const { theme } = this.scene;
      this.figures.forEach((figure, k) => {
        figure.colours = parts.figureColours(theme, k, this.figures.length, figure.item.colour);
        figure.shades = parts.shades(theme, figure.colours, this.chosen >= 0 && this.chosen !== k ? 0.72 : 0);
      });
      this.controls.colourChips();
      this.warpStrip.paint(theme);
      this.draw();
    }

    highlight(k) {
      this.chosen = k;
      this.colour();
    }

    setVisible(k, visible) {
      this.figures[k].visible = visible;
      this.place();
      this.warpStrip.show(this.figures, this.timeline);
      this.warpStrip.paint(this.scene.theme);
      this.touch(true);
    }

    setLayout(layout) {
      if (this.figures.length < 2) return;
      this.layout = layout;
      this.camera.reset(parts.homeView(this.figures, layout));
      this.place();
      this.say(layout === "side" ? "Side by side" : "Laid over one another");
    }

    setSync(sync) {
      if (!this.figures.some((figure) => figure.warp)) return;
      const share = this.clock.duration ? this.clock.time / this.clock.duration : 0;
      this.sync = sync;
      this.prepare();
      this.clock.seek(share * this.clock.duration);
      this.say(this.timeline.warped ? "In step" : "Each at its own pace");
    }

    play() {
      this.clock.play();
      this.touch(true);
    }

    pause() {
      this.clock.playing = false;
      this.touch(true);
    }

    seek(time) {
      this.clock.seek(time);
      this.touch();
    }

    step(frames) {
      this.clock.playing = false;
      const { fps } = this.timeline;
      this.seek(Math.round(this.clock.time * fps + frames) / fps);
      this.controls.update();
    }

    resetCamera() {
      this.camera.reset(parts.homeView(this.figures, this.layout));
      this.place();
      this.say("View reset");
    }

    /** Something changed: draw, bring the buttons in line (`byHand`: the person did it), tell the app. */
    touch(byHand) {
      if (byHand) this.controls.update();
      this.draw();
      this.tell();
    }

    draw() {
      this.dirty = true;
    }

    tell() {
      if (this.telling || this.status !== "ready") return;
      this.telling = setTimeout(() => {
        this.telling = 0;
        window.dispatchEvent(new CustomEvent("stage-state", { detail: this.state() }));
      }, STATE_EVERY);
    }

    tick(now) {
      if (this.closed) return;
      requestAnimationFrame(this.frame);
      const seconds = Math.min(Math.max((now - (this.before ?? now)) / 1000, 0), 0.25);
      this.before = now;
      if (this.status !== "ready" && !this.dirty) return;
      const playing = this.clock.playing;
      if (playing) {
        this.clock.advance(seconds);
        this.fps += ((seconds > 0 ? 1 / seconds : 60) - this.fps) * 0.05;
        if (!this.clock.playing) this.touch(true);
      }
      if (!playing && !this.dirty) return;
      this.dirty = false;
      this.paint(seconds);
    }

    paint(seconds) {
      for (const figure of this.figures) if (figure.visible) figure.pose(this.clock.time);
      if (this.figures.length) {
        const [x, z] = parts.groundCentre(this.figures, this.followed);
        const { camera } = this;
        if (camera.follow) camera.track(x, z, seconds, this.clock.jumped || !this.clock.playing);
        this.clock.jumped = false;
      }
      this.scene.paint(this.camera, this.figures, this.traces, this.clock, this.layout === "overlay");
      this.controls.tick(this.figures.length ? this.readout() : "");
    }

    readout() {
      const frame = this.figures[this.timeline.reference].recordedFrame(this.clock.time);
      return `${this.clock.time.toFixed(2)} / ${this.clock.duration.toFixed(2)} s · frame ${frame}`;
    }

    setStatus(status, message = "") {
      this.status = status;
      this.root.dataset.status = status;
      this.root.querySelector(".ms-stage-title").textContent = this.request?.title || (status === "empty" ? "" : this.request?.items[0]?.label || "");
      this.root.querySelector(".ms-message-text").textContent = message;
      this.root.querySelector(".ms-stage-note").hidden = true;
      const n = this.figures.length;
      this.scene.canvas.setAttribute("aria-label", status === "ready"
        ? `${n === 1 ? "One figure" : `${n} figures`} moving: ${this.figures.slice(0, 6).map((f) => f.label).join(", ")}`
        : "Stage for moving figures");
      this.controls.update();
      this.draw();
    }

    say(text) {
      const toast = this.root.querySelector(".ms-toast");
      toast.textContent = text;
      toast.classList.add("ms-shown");
      clearTimeout(this.quiet);
      this.quiet = setTimeout(() => toast.classList.remove("ms-shown"), 1100);
    }

    /** Open or close the list of keys; true when it was open. */
    toggleHelp(open) {
      const help = this.root.querySelector(".ms-help");
      const was = !help.hidden;
      help.hidden = open === undefined ? was : !open;
      return was;
    }

    /** What one sees, small enough for a link. */
    state() {
      const { clock, camera, traces } = this;
      const round = (value) => Math.round(value * 1000) / 1000;
      return {
        time: round(clock.time), speed: clock.speed, loop: clock.loop, playing: clock.playing,
        layout: this.layout, sync: this.sync, ghosts: traces.ghosts, trails: traces.trails,
        hidden: this.figures.flatMap((figure, k) => (figure.visible ? [] : [k])),
        camera: {
          yaw: round(camera.yaw), pitch: round(camera.pitch), distance: round(camera.distance),
          pan: camera.pan.map(round), follow: camera.follow, centre: camera.follow ? undefined : camera.centre.map(round),
        },
      };
    }

    /** Take up a state again; what is missing or makes no sense stays as it is. */
    restore(state) {
      if (this.status !== "ready") {
        this.waiting = state;
        return;
      }
      this.waiting = undefined;
      const { clock, camera, traces } = this;
      const number = (value, otherwise) => (Number.isFinite(value) ? value : otherwise);
      const oneOf = (value, choices, otherwise) => (choices.includes(value) ? value : otherwise);
      this.layout = oneOf(state.layout, ["overlay", "side"], this.layout);
      this.sync = oneOf(state.sync, ["warp", "start"], this.sync);
      this.figures.forEach((figure, k) => (figure.visible = !state.hidden?.includes(k)));
      traces.ghosts = Boolean(state.ghosts ?? traces.ghosts);
      traces.trails = oneOf(state.trails, parts.TRAILS, traces.trails);
      clock.speed = Math.min(Math.max(number(state.speed, clock.speed), 0.1), 4);
      clock.loop = oneOf(state.loop, ["loop", "bounce", "once"], clock.loop);
      this.prepare();
      const seen = state.camera || {};
      camera.moved = Number.isFinite(seen.distance) || camera.moved;
      for (const name of ["yaw", "pitch", "distance"]) camera[name] = number(seen[name], camera[name]);
      if (seen.pan?.length === 3 && seen.pan.every(Number.isFinite)) camera.pan = [...seen.pan];
      if (seen.centre?.length === 2 && seen.centre.every(Number.isFinite)) camera.centre = [...seen.centre];
      camera.follow = Boolean(seen.follow ?? camera.follow);
      clock.seek(number(state.time, clock.time));
      clock.playing = Boolean(state.playing ?? clock.playing) && !calm();
      this.touch(true);
    }
  }

  let stage = null;
  let mounted = null;
  let early = null; // a request or state that came before the page held a stage

  /** Take hold of the page's stage; again when the page was rebuilt. */
  function mount() {
    const root = document.getElementById("stage");
    if (root === mounted) return;
    mounted = root; // also where the next line fails: once is enough
    stage?.close();
    stage = null;
    stage = root ? new Stage(root) : null;
    if (stage && early?.request) stage.show(early.request);
    if (stage && early?.state) stage.restore(early.state);
    if (stage) early = null;
  }

  window.motionscapeStage = {
    show(request) {
      mount();
      if (!stage) early = { ...early, request };
      else if (JSON.stringify(request) !== JSON.stringify(stage.request) || stage.status === "error") return stage.show(request);
      return undefined;
    },
    restore(state) {
      if (!state) return;
      if (stage) stage.restore(state);
      else early = { ...early, state };
    },
    state: () => stage?.state(),
    play: () => stage?.play(),
    pause: () => stage?.pause(),
    seek: (time) => stage?.seek(time),
    get time() { return stage?.clock.time ?? 0; },
    get duration() { return stage?.clock.duration ?? 0; },
    get frame() { return stage?.figures.length ? stage.figures[stage.timeline.reference].recordedFrame(stage.clock.time) : 0; },
    /** Frame of each figure, counted from its start, at a time in seconds. */
    framesAt: (time) => stage?.figures.map((figure) => figure.frameAt(time) * figure.header.step),
    get camera() { return stage?.state().camera; },
    get playing() { return stage?.clock.playing ?? false; },
    get speed() { return stage?.clock.speed ?? 1; },
    get fps() { return stage?.fps ?? 0; },
    get figures() { return stage?.figures.filter((figure) => figure.visible).length ?? 0; },
    get layout() { return stage?.layout; },
    get sync() { return stage?.timeline.warped ? "warp" : "start"; },
    get status() { return stage?.status ?? "absent"; },
  };

  document.addEventListener("DOMContentLoaded", () => {
    mount();
    new MutationObserver(mount).observe(document.body, { childList: true, subtree: true });
  });
})((window.motionscapeStageParts ||= {}));
