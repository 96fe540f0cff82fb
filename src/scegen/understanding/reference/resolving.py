"""Resolves the mentions of a text in their order, with what the clauses say about them."""

from itertools import pairwise, product, takewhile

from scegen.scenario.vocabulary import ParticipantKind
from scegen.understanding.chunks import Chunk, Event, Mention, NounPhrase, Thing
from scegen.understanding.clauses.located import is_it
from scegen.understanding.entity import Basis
from scegen.understanding.lexicon import word_list
from scegen.understanding.phrases.lookahead import ends
from scegen.understanding.reference.bonds import Bonds, bonds_of
from scegen.understanding.reference.describing import describe
from scegen.understanding.reference.discourse import resolve
from scegen.understanding.reference.egos import cast_both, rank, the_teller
from scegen.understanding.reference.generic import mark_generic
from scegen.understanding.reference.mention_words import is_pronoun, tells
from scegen.understanding.reference.own_vehicles import is_apart, teller_goes_by
from scegen.understanding.reference.roster import Roster
from scegen.understanding.words.terms import NOTHING

_BARE = 2
"""Words of "the vehicle"."""
_BACKWARDS = {"ahead": "behind", "behind": "ahead"}


def resolve_mentions(chunks: list[Chunk], events: list[Event], roster: Roster) -> None:
    """Finds out whom every mention refers to, in the order of the text."""
    describe(chunks, events, roster.tokens)
    teller = teller_goes_by(chunks, events, roster.tokens)
    roster.teller = teller or ParticipantKind.CAR
    roster.apart = is_apart(chunks) and teller is not None
    mark_generic(chunks, events, roster.tokens)
    rank(chunks, events, roster.tokens)
    cast_both(chunks, events)
    bonds = bonds_of(chunks, events, roster.tokens)
    owned = [c.owner for c in chunks if isinstance(c, Mention | Thing) and c.owner is not None]
    # "the neighbour's van": the van takes part, the neighbour does not
    owners = {id(m) for m in owned if not any("afoot" in h.data for h in m.heads[-1:])}
    stand = {id(m): e for e in events if e.name == "park" and not e.negated for m in e.subject}
    waiting: list[Mention] = []
    early: list[Mention] = []
    for chunk in chunks:
        _told_by_somebody(chunk, roster)
        if not isinstance(chunk, Mention) or (id(chunk) in owners and chunk.noun == "pedestrian"):
            continue
        if chunk.whole is not None and chunk.pronoun in word_list("parts"):
            waiting.append(chunk)
            continue
        if is_pronoun(chunk) and _named_later(chunk, chunks, bonds.unlike[id(chunk)]):
            early.append(chunk)
            continue
        bonds.unlike[id(chunk)] += [m for it in early for m in bonds.unlike[id(it)]]
        if (tested := _tested(chunk, chunks, bonds.unlike[id(chunk)], roster)) is not None:
            bonds.again[id(chunk)] = tested
        _resolve(chunk, roster, bonds)
        if id(chunk) in stand:
            _parked(chunk, stand[id(chunk)])
        if early and id(chunk) in bonds.subjects:
            waiting, early = [*waiting, *early], []
        for earlier in waiting:
            _resolve(earlier, roster, bonds)
        waiting = []
    unnamed = [m for e in events for m in e.subject if tells(m) and not m.entities]  # "my tail"
    for mention in (*waiting, *early, *unnamed):
        _resolve(mention, roster, bonds)


def _told_by_somebody(chunk: Chunk, roster: Roster) -> None:
    """``in our lane``, ``sits on my bumper``: whoever tells it takes part."""
    said = roster.tokens[chunk.i : chunk.j] if not isinstance(chunk, Mention) else []
    if not word_list("of_the_teller").isdisjoint([token.low for token in said]):
        the_teller(roster, ParticipantKind.CAR, Basis(chunk.i, chunk.j))


def _parked(mention: Mention, event: Event) -> None:
    """``vehicle 1 was parked``: from then on, "the parked vehicle" is that one."""
    for entity in mention.entities if event.form == "ed" else []:
        entity.parked = entity.parked or (entity.is_vehicle and not entity.ego)


def _named_later(pronoun: Mention, chunks: list[Chunk], unlike: list[NounPhrase]) -> bool:
    """``before it turns right, the ego …``, ``with a bus behind it, the ego …``: named later."""
    known = [c for c in chunks if isinstance(c, Mention) and c.entities]
    before = pairwise([NOTHING, *(c for c in chunks if c.i < pronoun.i)])
    openers = [b for b, c in before if c.cat == "sub" or c.value == "with"]
    opened = any(ends(b) or not known for b in openers)
    after = takewhile(lambda c: c.value not in {".", ";"}, (c for c in chunks if c.i > pronoun.i))
    named = any(isinstance(c, Mention) and c.heads for c in after)
    return opened and named and all(c in unlike for c in known)


def _tested(
    mention: Mention, chunks: list[Chunk], unlike: list[NounPhrase], roster: Roster
) -> Mention | None:
    """``is hit at 25 % of the vehicle's width; VUT at 40 km/h``: nobody else is there but that."""
    generic = word_list("generic_words") - word_list("targets")
    bare = mention.j - mention.i == _BARE and mention.opened_by("def") and not mention.pps
    bare = bare and roster.tokens[mention.j - 1].base in generic
    told = [m.entities for m in unlike if isinstance(m, Mention)]
    others = [e for e in roster.entities if e.is_vehicle and [e] not in told]
    if not bare or others or roster.draft.ego or not (mention.prep or mention.possessor):
        return None
    named = (c for c in chunks if isinstance(c, Mention) and c.i > mention.i and c.is_ego)
    return next(named, None)


def _resolve(mention: Mention, roster: Roster, bonds: Bonds) -> None:
    unlike = [m for m in bonds.unlike[id(mention)] if isinstance(m, Mention)]
    if mention.joined is not None and mention.pronoun is None:
        unlike.append(mention.joined)  # "a van and the van behind": two
    exclude = [e for m in unlike for e in m.entities]
    mention.same_as = bonds.again.get(id(mention), mention.same_as)
    known = roster.entities
    egos = [e for e in known if e.ego]
    hides = id(mention) in bonds.hiding and is_it(mention) and len(egos) < len(known)
    still = [e for e in known if e.still or "stationary" in e.named_by]
    if hides and still:
        exclude += [e for e in known if e not in still]  # "passes a halted bus …, out behind it"
    if hides or any(m.is_ego for m in unlike):
        exclude += egos  # who looks on hides nobody from itself
    resolve(
        roster,
        mention,
        subject=id(mention) in bonds.subjects,
        exclude=exclude,
        sides=bonds.everywhere.get(id(mention)),
        settled=id(mention) in bonds.settled,
        near=bonds.landmarks.get(id(mention)),
    )
    loci = _seen_from_the_ego(mention, unlike, bonds.follows[id(mention)])
    for entity in mention.entities:
        entity.loci |= loci
        entity.nears = not entity.ego if id(mention) in bonds.nearing else entity.nears
    for who, locus, by in bonds.along[id(mention)]:
        there = [e for e in roster.entities if locus in e.loci]  # who is named first is nearest
        if not there and (by is None or any(e.ego for e in by.entities)):
            for entity in who.entities:
                entity.loci |= {locus}
        elif by is not None and by.entities and not (egos or by.dirs):
            # "one car follows another; the leading car brakes"
            for entity, place in (*product(who.entities, [locus]),
                                  *product(by.entities, [_BACKWARDS[locus]])):  # fmt: skip
                entity.loci |= {place}


def _seen_from_the_ego(mention: Mention, placed: list[Mention], events: list[Event]) -> set[str]:
    """``I am behind a lorry``, ``the ego follows a car``: that is "the car ahead"."""
    told = [e for e in events if not (e.passive or e.negated)]
    loci = {"ahead" for event in told for who in event.doers if who.ego}
    phrases = [p for m in placed if any(e.ego for e in m.entities) for p in m.pps]
    places = [p.value for p in phrases if p.target is mention]
    return loci | {_BACKWARDS[word] for word in places if word in _BACKWARDS}
