/* The rows of the job bar. Elements are changed in place: a row that is replaced with every percent would lose a click
   that has begun, and the keyboard's focus, away with it. */
import { clientside, register } from "../shared/dash.mjs";
import { allWithin, childrenOf, element, icon, need, within } from "../shared/dom.mjs";
import * as ids from "./ids.mjs";
/** @import { Job } from "./types.d.ts" */
/** @import { Child } from "../shared/dom.mjs" */

/**
 * A button that asks for something to be done with the job (shell/selecting.mjs, webapp/jobs/job_bar.py).
 * @param {string} action
 * @param {number} job
 * @param {string} className
 * @param {...Child} children
 */
function button(action, job, className, ...children) {
  const made = element("button", "job-button " + className, ...children);
  made.type = "button";
  made.dataset.store = ids.JOB_ACTION;
  made.dataset.value = JSON.stringify({ action, job });
  made.dataset.stamp = "yes";
  return made;
}

/** @param {Job} job */
function alive({ id, title }) {
  const spinner = element("span", "spinner");
  spinner.setAttribute("aria-hidden", "true");
  const progress = element("div", "job-progress", element("div", ""));
  progress.setAttribute("role", "progressbar");
  progress.setAttribute("aria-label", `Progress of ${title}`);
  const percent = element("span", "job-percent");
  percent.setAttribute("aria-hidden", "true"); // the progress bar says it
  return element("div", "job", spinner, element("span", "job-title ellipsis", title), progress,
    element("span", "job-stage number", element("span", "job-words"), percent, element("span", "job-expected")),
    element("div", "job-actions", button("start", id, "job-start for-editors", "Start anyway"), button("cancel", id, "job-cancel", "Cancel")));
}

/**
 * Of a row, or of the place in a page where the job's outcome is awaited (webapp/jobs).
 * @param {HTMLElement} row
 * @param {Job} job
 */
function update(row, { stage, percent, stopping, held, expected }) {
  const progress = within(row, ".job-progress"), known = percent !== null;
  progress.classList.toggle("waiting", !known);
  childrenOf(progress)[0].style.width = (percent || 0) + "%";
  if (known) progress.setAttribute("aria-valuenow", String(percent));
  else progress.removeAttribute("aria-valuenow");
  const words = within(row, ".job-words"); // announced when they change, so written only then
  if (words.textContent !== stage) words.textContent = stage;
  const took = row.querySelector(".job-expected");
  if (took && took.textContent !== (expected || "")) took.textContent = expected || "";
  row.classList.toggle("held", Boolean(held));
  const number = row.querySelector(".job-percent");
  if (number) number.textContent = percent ? ` ${percent} %` : "";
  within(row, ".job-cancel").disabled = stopping;
}

/** @param {Job} job */
function failed({ id, title, error }) {
  const sign = element("span", "job-mark-failed", icon("error", 18));
  const dismiss = button("dismiss", id, "job-button-plain", icon("close", 16));
  dismiss.setAttribute("aria-label", "Dismiss");
  return element("div", "job job-failed", sign, element("span", "job-title ellipsis", title), element("span", "job-message", error),
    element("div", "job-actions", button("retry", id, "", "Try again"), dismiss));
}

register("jobs", {
  /** @param {Job[] | null} jobs */
  show(jobs) {
    const box = need(ids.JOB_LIST);
    const wanted = (jobs || []).map((job) => /** @type {[string, Job]} */ ([job.error ? `${job.id} failed` : String(job.id), job]));
    const names = new Set(wanted.map(([name]) => name));
    for (const row of childrenOf(box)) if (!names.has(row.dataset.job ?? "")) row.remove();
    wanted.forEach(([name, job], k) => {
      /** @type {HTMLElement | undefined} */
      let row = childrenOf(box)[k];
      if (!row || row.dataset.job !== name) { // jobs stand in order of their numbers: those that stay need not move
        row = job.error ? failed(job) : alive(job);
        row.dataset.job = name;
        box.insertBefore(row, box.children[k] || null);
      }
      if (!job.error) allWithin(document, `[data-job="${name}"]`).forEach((place) => update(place, job));
    });
    return clientside.no_update;
  },
});
