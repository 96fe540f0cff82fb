"""Values of options that more than one command takes."""

from __future__ import annotations

from enum import StrEnum


class OscVersion(StrEnum):
    """Versions of OpenSCENARIO that can be written."""

    V1_0 = "1.0"
    V1_2 = "1.2"


class CheckDepth(StrEnum):
    """How deep to check: nothing, all but the ASAM checkers, everything."""

    NONE = "none"
    QUICK = "quick"
    FULL = "full"
