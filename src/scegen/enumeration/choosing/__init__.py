"""Choosing among logical scenarios: by expression, by richness, by variety, by coverage."""
