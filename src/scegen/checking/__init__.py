"""An independent verdict on exported files: it reads the files, never our own models of them.

``check_folder`` and ``check_files`` run every checker that is installed; one that is not, or
that could not look at everything, says ``not_run``, which is never a pass.
"""

from scegen.checking.check import (
    CHECKERS,
    QUICK_CHECKERS,
    REPLAY,
    check_files,
    check_folder,
)
from scegen.checking.results import CheckReport, CheckResult, CheckStatus, Finding, Severity
from scegen.checking.table import reports_table

__all__ = [
    "CHECKERS",
    "QUICK_CHECKERS",
    "REPLAY",
    "CheckReport",
    "CheckResult",
    "CheckStatus",
    "Finding",
    "Severity",
    "check_files",
    "check_folder",
    "reports_table",
]
