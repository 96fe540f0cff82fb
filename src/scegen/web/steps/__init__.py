"""The five steps of the page."""
