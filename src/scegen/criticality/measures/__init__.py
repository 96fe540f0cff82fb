"""Measures of criticality, one per file; ``registry`` lists them as data.

Each file says what it measures, in which unit, which direction is worse, after whom and where it
holds; it has a kernel for one moment, one for the worst over time, and one over whole batches.
"""
