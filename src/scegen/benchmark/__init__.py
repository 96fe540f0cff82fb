"""Measured claims: the source paper's own experiment, and understanding by labelled files."""
