"""Long work: starting it in processes of its own, the job bar, and changes of a dataset with their undo."""

from webapp.jobs.launching import background_manager, limit, restart, start, supervise, tend, work

__all__ = ["background_manager", "limit", "restart", "start", "supervise", "tend", "work"]
