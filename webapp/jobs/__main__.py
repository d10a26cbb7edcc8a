"""``python -m webapp.jobs``: a worker, its child, or the process that starts a worker (see ``launching``)."""

import sys

from webapp.jobs.launching import main

main(sys.argv[1:])
