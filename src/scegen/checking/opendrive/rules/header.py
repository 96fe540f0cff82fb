"""The file says that it is OpenDRIVE 1.7, as our own do."""

from __future__ import annotations

from collections.abc import Iterator

from scegen.checking.opendrive.network import Network
from scegen.checking.results import Finding, error

VERSION = ("1", "7")
"""1.7 is the newest version whose schema lxml can read, and for which ASAM's rules all run."""


def check_version(network: Network) -> Iterator[Finding]:
    """``xodr.version``: revMajor and revMinor are 1 and 7."""
    if network.version != VERSION:
        found = ".".join(network.version)
        yield error("xodr.version", "header", f"version {found} instead of {'.'.join(VERSION)}")
