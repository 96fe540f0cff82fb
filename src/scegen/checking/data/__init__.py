"""Files that the checkers ship: pinned versions and the runner of the ASAM environment."""
