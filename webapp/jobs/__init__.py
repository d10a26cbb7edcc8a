"""Long computations: jobs in processes of their own, the job bar, and changes of a dataset with their undo."""

from webapp.jobs.launching import background_manager, ensure_worker, get_ready, limit, restart, resume, start, wait_for

__all__ = ["background_manager", "ensure_worker", "get_ready", "limit", "restart", "resume", "start", "wait_for"]
