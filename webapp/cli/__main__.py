"""``python -m webapp.cli``: the command ``motionscape``."""

import sys

from webapp.cli.main import main

sys.exit(main())
