"""Amounts: what numbers say of participants and of what they do, and when it happens."""
