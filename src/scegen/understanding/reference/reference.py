"""What the form of a noun phrase says about whom it can mean."""

from __future__ import annotations

from scegen.scenario.vocabulary import ON_FOOT
from scegen.understanding.chunks import Mention
from scegen.understanding.draft import Draft
from scegen.understanding.entity import Basis, Entity
from scegen.understanding.lexicon import word_list
from scegen.understanding.reference.mention_words import Reading, read_mention

_DENSITY = frozenset({"manner", "inert", "unknown", "noted"})
"""Classes of words that say how dense traffic is."""


def is_pronoun(target: object) -> bool:
    """Whether a noun is "it", "him" or "they"."""
    return isinstance(target, Mention) and target.pronoun in {"it", "him", "they"}


def refers_to_nobody(mention: Mention) -> bool:
    """``in traffic``, ``no pedestrians``, ``at the second``: words that name no participant."""
    prep = mention.opening
    first = [m.value for m in mention.mods[:1]]
    several = mention.is_mass or mention.plural
    if prep == "without" and (
        first in (["indef"], ["other"], ["another"]) or (not first and several)
    ):
        return True  # "without any target", "without other cars", "free of traffic"
    mass = mention.is_mass and all(
        m.cat in _DENSITY or (m.cat, m.value) == ("label", "quality") for m in mention.mods
    )
    if mass and prep in {"in", "of", "for"}:
        return True
    gathered = bool(mention.mods) and mention.mods[0].cat in {"det", "quant"}
    gathered = gathered and mention.mods[0].j - mention.mods[0].i > 1
    if gathered and prep == "with" and mention.is_mass:
        return True  # "travels with the flow of traffic"
    place = mention.pronoun == "ordinal" and prep == "in"  # "at the first junction …, the second"
    return place or mention.negated or mention.pronoun in {"reflexive", "nobody"}


def kin(reading: Reading, mention: Mention) -> bool:
    """``her daughter``, ``his two children``: nobody who was called otherwise."""
    people = reading.kind in ON_FOOT and not reading.driver
    return people and mention.opened_by("its")


def tells(mention: Mention) -> bool:
    """Whether it is the one who tells it ("I", "we")."""
    return mention.is_me or any("speaks" in h.data for h in mention.heads)


def elsewhere(reading: Reading, mention: Mention, entity: Entity) -> bool:
    """``lead car brakes; car on the left``: a bare noun with a place of its own is another one."""
    called = reading.called - entity.named_by - word_list("wider_names")
    if entity.ego and called and "speaks" in entity.named_by:
        return True  # "this Audi": not the one who tells it
    if entity.ego and mention.has("verb", "approach"):
        return True  # "the ego turns; the approaching car …": it comes towards the ego
    bare = reading.det == "bare" and not reading.dirs and reading.kind is entity.kind
    return bare and bool(mention.pps) and bool(entity.dirs)


def refine(mention: Mention, draft: Draft) -> None:
    """``vehicle 1, a pickup truck, …``: it says what kind that is, or that it is the ego."""
    if not mention.heads:
        return
    reading = read_mention(mention, draft.tokens, None)
    afoot = any("afoot" in h.data for h in mention.heads)
    ego = draft.ego
    for entity in mention.entities:
        if not reading.generic and (reading.kind not in ON_FOOT or afoot):
            entity.kind, entity.basis = reading.kind, Basis(mention.i, mention.j)
        entity.ego = entity.ego or (reading.ego and ego is None)
        entity.labels |= reading.labels
        entity.named_by |= reading.called
