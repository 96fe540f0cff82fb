"""Meaning: what events say about movements, positions and dangers."""
