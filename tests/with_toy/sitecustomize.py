"""Python loads this at its start where the folder is in PYTHONPATH: workers then know the toy method."""

import sys

if {"webapp.jobs", "webapp.jobs.celery_workers"} & set(sys.orig_argv) and "--detach" not in sys.orig_argv:
    import tests.toy_method  # noqa: F401
