"""Raising the danger of a scenario: pairs and proposals in turn, and a proof in the end."""
