"""Between whom a distance or a time lies, by the words around it."""

from __future__ import annotations

from itertools import pairwise

from scegen.scenario.vocabulary import Approach
from scegen.understanding.amounts.sentences import Sentences
from scegen.understanding.amounts.whom import counterpart, ego_of
from scegen.understanding.chunks import Mention, Place, Word
from scegen.understanding.draft import Entity
from scegen.understanding.frames import Measured
from scegen.understanding.semantics.context import Context

_PAIR = 2


def row_of(number: Measured, text: Sentences, context: Context) -> list[tuple[Entity, Entity]]:
    """``two cars drive ahead of the ego with 20 m between each``: from one to the next.

    Args:
        number: the distance or time.
        text: the text with its clauses.
        context: the scenario in the making.
    """
    if not number.around.opens("in_a_row"):
        return []
    start, _ = text.bounds(number.i)
    own = {id(c.owner) for c in text.chunks if isinstance(c, Place)}  # "in the ego's lane"
    named = [
        e for m in text.mentions if start <= m.i < number.i and id(m) not in own for e in m.entities
    ]
    members = list(dict.fromkeys(named))
    leaders = {
        id(e): {
            id(p.entity)
            for p in context.draft.placements
            if p.approaches == {Approach.AHEAD} and (p.reference or ego_of(context)) is e
        }
        for e in members
    }
    members.sort(key=lambda e: len(leaders[id(e)] & set(leaders)), reverse=True)
    pairs = list(pairwise(members))
    known = all(id(b) in leaders[id(a)] for a, b in pairs)
    if not known and not any(leaders[id(e)] & set(leaders) for e in members):
        known = _in_one_file(members, context)  # in whichever order: they are alike
    return pairs if known else []


def _in_one_file(members: list[Entity], context: Context) -> bool:
    """``three cars stand in the ego's lane``: one behind the other, the first named in front."""
    ego = ego_of(context)
    ahead = all(
        any(
            p.entity is e and p.approaches == {Approach.AHEAD} and p.reference in (None, ego)
            for p in context.draft.placements
        )
        or e.stands is not None
        for e in members
    )
    alike = len({e.kind for e in members}) == 1
    if not (ahead and alike and ego is not None and ego not in members):
        return False
    for leader, follower in pairwise(members):
        context.draft.place(leader, follower, {Approach.AHEAD}, leader.basis)
    return True


def pair_of(number: Measured, text: Sentences, context: Context) -> tuple[Entity, Entity] | None:
    """Who lies how far from whom.

    Args:
        number: the distance or time.
        text: the text with its clauses.
        context: the scenario in the making.
    """
    if " the next " in f"{' '.join(number.around.after.split()[:4])} ":
        return None  # "each 3 m clear of the next"
    after = text.phrase_after(number.j)
    noun = after[1] if after is not None else None
    own = noun is not None and any(m.cat == "possessive" for m in noun.mods)
    named = text.named(noun) if not own else []
    located = after is not None and isinstance(after[0], Word) and after[0].cat == "locus"
    scene = text.scene_at(number.i, number.j)
    subject = text.subject_before(number.i)
    word = after[0] if located and after is not None else None
    holder = [m for m in text.mentions for p in m.pps if p.word is word and m.i < number.i]
    if holder and len(holder[0].entities) == 1 and named:
        subject = holder[0].entities  # "beside a van which is 60 m ahead of the ego": the van
    if isinstance(noun, Mention) and noun.pronoun is not None and named == subject:
        named = []  # "and the ego, 15 m behind it": not behind itself
    pairs = [m.entities for m in text.mentions if m.i < number.i and len(m.entities) == _PAIR]
    if number.around.opens("between_two") and pairs:
        return pairs[-1][0], pairs[-1][1]
    bracketed = _bracketed(number, text)
    if bracketed is not None and subject and bracketed not in subject:
        return subject[0], bracketed
    by_verb = number.frame.role in {"overlap", "headway", "ttc"} or not (named or located)
    pronoun = isinstance(noun, Mention) and noun.pronoun is not None
    if pronoun and scene is not None and scene.event.name == "follow":
        by_verb = True  # "follows a car 30 m behind it", "follows a truck 25 m in front of it"
    if by_verb and scene is not None and scene.actors and scene.targets:
        told = [e for e in scene.actors if subject == [e]]  # "one 15 m and the other 40 m behind"
        return (told or scene.actors)[0], scene.targets[0]
    subject = [e for e in subject if e not in named]
    if not subject and scene is not None:
        subject = [e for e in scene.actors if e not in named]
    if subject and named and (located or number.frame.role != "overlap"):
        return subject[0], named[0]
    near = [e for m in text.mentions if m.i < number.i for e in m.entities]
    first = subject[0] if subject else named[0] if named else ego_of(context)
    if first is None:
        return None
    other = counterpart(first, context, near)
    return (first, other) if other is not None and other is not first else None


def _bracketed(number: Measured, text: Sentences) -> Entity | None:
    """``in front of a stationary target (TTC 3 s)``: to whom it is."""
    tokens = text.tokens
    opening = next(
        (k for k in range(number.i - 1, max(-1, number.i - 4), -1) if tokens[k].low == "("),
        None,
    )
    if opening is None:
        return None
    before = [m for m in text.mentions if m.j == opening and m.entities]
    first: Entity | None = before[0].entities[0] if before else None
    return first
