"""Bound to the ego, not to the clock: dangers that wait for whoever drives it."""
