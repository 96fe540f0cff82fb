"""Rules of the road: who has which duty at a junction, and what keeping it means.

Who must keep which rule follows from the functional and the logical scenario alone, so that
whoever lays programs and whoever judges movements ask the same question and nobody the other.
"""
