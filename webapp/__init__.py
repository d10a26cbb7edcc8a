"""The Dash app and the command line. They, and not ``core``, decide how many threads linear algebra may have."""

import os

# One: jobs, requests and the browser share the cores, and threads of small products wait for one another longer than
# they gain (on a busy machine tenfold; alone, a second thread saves 3 % of a motif analysis). numpy reads it when it is
# first imported; the processes of jobs inherit it.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
