"""Clauses: who does what to whom, verb by verb."""
