"""``with siren and blue lights``: an emergency vehicle to which everybody gives way."""

from __future__ import annotations

from scegen.scenario.vocabulary import ParticipantKind
from scegen.understanding.draft import Draft
from scegen.understanding.entity import Basis
from scegen.understanding.words import absent
from scegen.understanding.words.terms import Term


def read_calls(terms: list[Term], draft: Draft) -> None:
    """Put on call whose siren or blue lights are on: the emergency vehicle named last before."""
    able = [e for e in draft.entities if e.kind is ParticipantKind.EMERGENCY_VEHICLE]
    for k, term in enumerate(terms):
        if "on_call" not in term.data or absent.negated(terms, k) or not able:
            continue
        before = [e for e in able if e.basis.i is not None and e.basis.i <= term.i]
        whose = max(before, key=lambda e: e.basis.i or 0, default=able[0])
        whose.on_call = whose.on_call or Basis(term.i, term.j)
