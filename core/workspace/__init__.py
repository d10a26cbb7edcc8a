"""Data sets, results and the job table on disk, addressed by content."""

from core.mocap.files import atomic_file
from core.workspace.audit import Audit
from core.workspace.blocks import Block, pinned_state
from core.workspace.boards import Board, Boards
from core.workspace.comments import Comment, Comments
from core.workspace.datasets import DatasetInfo
from core.workspace.documents import Change
from core.workspace.errors import (
    ConflictError,
    DocumentDamaged,
    DocumentGone,
    NameRefused,
    ResultDamaged,
    WorkspaceError,
    explain,
    plain_errors,
    was_interrupted,
)
from core.workspace.jobs import Job, JobTable
from core.workspace.names import check_name, clean_name
from core.workspace.notes import MotifNote, Notes
from core.workspace.people import ROLES, AccessRefused, Person, acting, acting_as
from core.workspace.ratings import Ratings
from core.workspace.results import Result, ResultStore
from core.workspace.uploads import Uploads, safe_parts
from core.workspace.users import Account, Users
from core.workspace.views import SavedView, Views
from core.workspace.workspace import Workspace, is_workspace, shared_workspace

__all__ = [
    "ROLES",
    "AccessRefused",
    "Account",
    "Audit",
    "Block",
    "Board",
    "Boards",
    "Change",
    "Comment",
    "Comments",
    "ConflictError",
    "DatasetInfo",
    "DocumentDamaged",
    "DocumentGone",
    "Job",
    "JobTable",
    "MotifNote",
    "NameRefused",
    "Notes",
    "Person",
    "Ratings",
    "Result",
    "ResultDamaged",
    "ResultStore",
    "SavedView",
    "Uploads",
    "Users",
    "Views",
    "Workspace",
    "WorkspaceError",
    "acting",
    "acting_as",
    "atomic_file",
    "check_name",
    "clean_name",
    "explain",
    "is_workspace",
    "pinned_state",
    "plain_errors",
    "safe_parts",
    "shared_workspace",
    "was_interrupted",
]
