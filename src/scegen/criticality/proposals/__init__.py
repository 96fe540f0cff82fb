"""Proposals: changes of numbers that somebody asks for with a reason, and what becomes of them.

A proposer sees a situation and its parameters with their bounds; the validator lets through what
is valid; the search begins there and goes on.
"""
