"""esmini's log: every error, and every warning that is not known to be harmless, is a finding."""

import re
from collections.abc import Iterator

from scegen.checking.results import Finding, Severity, error

LINE = re.compile(r"^\[(?P<time>[^\]]*)\] \[(?P<level>error|warn)\] (?P<text>.*)$")
HARMLESS = (
    # Models are pictures: without a window nobody sees them.
    re.compile(r"^3D model .* not located"),
    re.compile(r"^scene graph file .* not located"),
    re.compile(r"^Traffic sign mapping file .* not located"),
    # What later versions deprecate, the schema of 1.0 requires.
    re.compile(r"deprecated in v1\.\d.* Accepting it anyway"),
)
HARMLESS_AT_START = re.compile(r"^Stopping .* on conflicting ")
"""An entity that starts on its trajectory is both placed by Init and moved by it at t = 0."""
CONTACT = re.compile(r"^Collision between ")
"""Two boxes touch: what a critical scenario may want, so it is told but does not fail."""
SHOWN = 10


def check_log(text: str) -> Iterator[Finding]:
    """``esmini.log``: no errors, no warnings outside the list of harmless ones.

    ``esmini.contact`` tells which participants touch.
    """
    lines = [found for line in text.splitlines() if (found := LINE.match(line))]
    contacts = [line for line in lines if CONTACT.search(line["text"])]
    problems = [
        line
        for line in lines
        if line not in contacts and (line["level"] == "error" or not _harmless(line))
    ]
    for line in contacts:
        yield Finding("esmini.contact", Severity.INFO, _place(line), line["text"])
    for line in problems[:SHOWN]:
        yield error("esmini.log", _place(line), f"{line['level']}: {line['text']}")
    if len(problems) > SHOWN:
        yield error("esmini.log", "log", f"and {len(problems) - SHOWN} more errors and warnings")


def _place(line: re.Match[str]) -> str:
    return f"t = {line['time']} s" if line["time"] else "loading"


def _harmless(line: re.Match[str]) -> bool:
    if any(pattern.search(line["text"]) for pattern in HARMLESS):
        return True
    at_start = float(line["time"] or 0) == 0.0
    return at_start and HARMLESS_AT_START.search(line["text"]) is not None
