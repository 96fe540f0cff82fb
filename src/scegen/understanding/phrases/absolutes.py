"""What is said of a light in a phrase of its own: "with the signal just turned green"."""

from __future__ import annotations
