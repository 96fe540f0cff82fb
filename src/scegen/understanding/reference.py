"""What the form of a noun phrase says about whom it can mean."""

from __future__ import annotations

from scegen.understanding.chunks import Mention
from scegen.understanding.mention_words import Reading


def own_vehicle(reading: Reading, mention: Mention) -> bool:
    """``the driver opens the door of his vehicle``: what the driver stands for."""
    possessed = bool(mention.mods) and mention.mods[0].cat == "possessive"
    whose = possessed and mention.mods[0].value == "its"
    return whose and reading.generic and not reading.plural and not reading.dirs


def is_pronoun(target: object) -> bool:
    """Whether a noun is "it", "him" or "they"."""
    return isinstance(target, Mention) and target.pronoun in {"it", "him", "they"}


def as_the_ego_sees(mention: Mention) -> bool:
    """``the car ahead``, ``the car ahead of the ego``: placed by nobody but the ego."""
    return all(
        p.word.cat == "locus"
        and (
            p.target is None
            or (isinstance(p.target, Mention) and any(h.data.get("ego") for h in p.target.heads))
        )
        for p in mention.pps
    )


def loci_of(mention: Mention) -> set[str]:
    """Where a noun is said to be: "the car behind" is not "the car in front"."""
    loci = {p.value for p in mention.pps if p.word.cat == "locus"}
    return loci | ({"elsewhere"} if mention.elsewhere else set())


def refers_to_nobody(mention: Mention) -> bool:
    """``in traffic``, ``no pedestrians``, ``at the second``: words that name no participant."""
    prep = mention.prep.value if mention.prep is not None else ""
    mass = bool(mention.head and mention.head.data.get("mass")) and not mention.mods
    if mass and prep in {"in", "of", "for"}:
        return True
    place = mention.pronoun == "ordinal" and prep == "in"  # "at the first junction …, the second"
    return place or mention.negated or mention.pronoun == "reflexive"
