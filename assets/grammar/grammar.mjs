/* The Grammar page: which part draws what, and when. */
import { changeView, clientside, register } from "../shared/dash.mjs";
import { find } from "../shared/dom.mjs";
import { drawActions, drawOccurrences } from "./actions.mjs";
import { drawCompose } from "./compose.mjs";
import * as ids from "./ids.mjs";
import { drawOthers } from "./others.mjs";
import { drawRoutines } from "./routines.mjs";
import { drawRules } from "./rules.mjs";
import { state } from "./state.mjs";
import { drawString, markChosen } from "./strings.mjs";
/** @import { Composition, GrammarData, OtherWays, ShownRoutine } from "./types.d.ts" */
/** @import { Selection, View } from "../shared/types.d.ts" */

register("grammar", {
  /**
   * @param {GrammarData | null} data
   * @param {Selection | null} selection
   * @param {string | null} order
   * @param {unknown} _place
   */
  draw(data, selection, order, _place) {
    if (!data || !find(ids.GRAMMAR_STRING)) return clientside.no_update;
    state.data = data;
    drawString(data);
    drawActions(data, order);
    drawOccurrences(data, selection);
    drawRules(data);
    markChosen(selection);
    return clientside.no_update;
  },
  /**
   * A point of a chart over the number of actions: its result comes on the page.
   * @param {{ points?: { customdata?: any }[] } | null} click
   */
  open(click) {
    const change = click?.points?.[0]?.customdata;
    if (typeof change === "string") changeView(JSON.parse(change));
    return clientside.no_update;
  },
  /** @param {ShownRoutine | null} shown @param {GrammarData | null} data @param {View | null} view */
  routine(shown, data, view) {
    if (data) state.data = data;
    drawRoutines(shown, data, view || {});
    return clientside.no_update;
  },
  /**
   * @param {Composition | null} made
   * @param {View | null} view
   * @param {GrammarData | null} data
   * @param {Selection | null} selection
   */
  compose(made, view, data, selection) {
    if (data) state.data = data;
    drawCompose(made, view, selection);
    return clientside.no_update;
  },
  /** @param {OtherWays | null} data @param {View | null} view */
  others(data, view) {
    drawOthers(data, view || {});
    return clientside.no_update;
  },
});
