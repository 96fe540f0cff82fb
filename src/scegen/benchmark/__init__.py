"""Measured claims: the source paper's own experiment, repeated."""
