"""Whose movements are written, and as what."""

from __future__ import annotations

from enum import StrEnum


class TracePlayer(StrEnum):
    """Whose movements."""

    OWN = "own"
    ESMINI = "esmini"


class TraceFormat(StrEnum):
    """What a trace can be written as."""

    CSV = "csv"
    MCAP = "mcap"
