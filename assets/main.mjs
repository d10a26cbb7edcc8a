// Everything of the front end: importing a room's module is what makes it listen and lets Dash call its functions.
import "regenerator-runtime/runtime.js"; // Dash's component libraries expect it as a global
import "./shell/refusals.mjs"; // before loading.mjs, which takes its place in fetch and leaves it again
import "./shell/loading.mjs";
import "./shell/first_picture.mjs";
import "./shared/downloads.mjs";
import "./shell/frame.mjs";
import "./shell/keys.mjs";
import "./shell/menus.mjs";
import "./shell/palette.mjs";
import "./shell/selecting.mjs";
import "./shell/settings.mjs";
import "./shell/views.mjs";
import "./jobs/job_bar.mjs";
import "./boards/boards.mjs";
import "./boards/discussion.mjs";
import "./report/blocks.mjs";
import "./groups/groups.mjs";
import "./library/body.mjs";
import "./library/clips.mjs";
import "./library/properties.mjs";
import "./library/upload.mjs";
import "./clip/gait.mjs";
import "./clip/range.mjs";
import "./motifs/blend.mjs";
import "./motifs/compare.mjs";
import "./motifs/graph.mjs";
import "./motifs/motion_list.mjs";
import "./motifs/names.mjs";
import "./motifs/stability.mjs";
import "./motifs/timeline.mjs";
import "./motifs/walk.mjs";
import "./motion_map/export.mjs";
import "./search/by_words.mjs";
import "./search/study.mjs";
import "./sweeps/sweeps.mjs";
import { at, chartPlot } from "./clip/cursor.mjs";
import "./grammar/grammar.mjs";
import { setKeys } from "./motion_map/map.mjs";
import { editedPosture } from "./motion_map/posture_editor.mjs";
import { state } from "./motion_map/state.mjs";
import "./search/search.mjs";
import { now } from "./search/state.mjs";
import { drawings } from "./shared/downloads.mjs";
import { player } from "./stage/player.mjs";

// the one handle for tests and for a curious person's console
window.motionscape = {
  stage: player,
  drawings,
  clip: { at, plot: chartPlot },
  map: { state, setKeys, edited: editedPosture },
  search: { now },
};
