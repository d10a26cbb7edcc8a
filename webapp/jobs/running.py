"""What a page shows while a job computes its result."""

from __future__ import annotations

import dash_mantine_components as dmc
from dash import html
from dash.development.base_component import Component

from core.workspace import Job
from webapp.jobs import names
from webapp.jobs.job_bar import expected_words, stage_words
from webapp.shell.attributes import attributes
from webapp.shell.buttons import sends
from webapp.shell.icons import icon


def running(job: Job, title: str, symbol: str, class_name: str = "empty-state running") -> Component:
    """Stage, progress and buttons of a job, drawn once; assets/jobs/job_bar.mjs keeps them up to date."""
    has_fraction = job.state == "running" and not job.cancelling
    return html.Div(
        className=f"{class_name} held" if job.held else class_name,
        role="status",
        children=[
            html.Div(icon(symbol, 34), className="empty-icon"),
            dmc.Title(title, order=2, size="h4"),
            html.Div(stage_words(job), className="job-words muted"),
            html.Div(
                html.Div(style={"width": f"{round(100 * job.fraction)}%"}),
                className="job-progress" if has_fraction else "job-progress waiting",
                role="progressbar",
                **attributes(aria_label="Progress of this stage"),
            ),
            html.Div(expected_words(job.expected), className="job-expected muted number"),
            dmc.Group(
                [
                    dmc.Button(
                        "Start anyway",
                        className="job-start for-editors",
                        **sends(names.JOB_ACTION, {"action": "start", "job": job.id}, every_time=True),
                    ),
                    dmc.Button(
                        "Cancel",
                        variant="default",
                        className="job-cancel",
                        disabled=job.cancelling,
                        **sends(names.JOB_ACTION, {"action": "cancel", "job": job.id}, every_time=True),
                    ),
                ],
                gap="xs",
                mt="xs",
            ),
        ],
        **attributes(data_job=str(job.id)),
    )
