"""Hazards are formal: for every kind a predicate on movements with a quantitative margin."""
