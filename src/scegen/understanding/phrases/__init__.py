"""Phrases: terms grouped into noun phrases and events; titles, telegrams, courses."""
