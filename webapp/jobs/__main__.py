"""``python -m webapp.jobs``: a worker, or the process that starts one (see ``launching``)."""

import sys

from webapp.jobs.launching import main

if __name__ == "__main__":
    main(sys.argv[1:])
