"""A text as all who read amounts see it: its sentences, who is spoken of, what is found so far."""

from bisect import bisect_left
from collections.abc import Collection
from functools import cache

from scegen.scenario.acts import ActKind
from scegen.scenario.vocabulary import Approach
from scegen.understanding.chunks import Chunk, Mention, NounPhrase
from scegen.understanding.entity import Basis, Entity
from scegen.understanding.happenings import Doing, Happenings
from scegen.understanding.lexicon import word_list
from scegen.understanding.semantics.context import Clause, Context
from scegen.understanding.words.terms import Term

ANY: frozenset[ActKind] = frozenset(ActKind)
CHANGING = frozenset({ActKind.BRAKE, ActKind.ACCELERATE})
_ENDS = frozenset({".", ";", "!", "?"})


@cache
def _openings(name: str) -> dict[str, list[str]]:
    """The phrases of a list by their first words."""
    found: dict[str, list[str]] = {}
    for phrase in word_list(name):
        found.setdefault(phrase.partition(" ")[0], []).append(phrase)
    return found


class Telling:
    """A text with its clauses, mentions resolved, and what it tells of."""

    def __init__(
        self, chunks: list[Chunk], scenes: list[Clause], context: Context, ego: Entity
    ) -> None:
        self.ego = ego
        self.tokens = context.tokens
        self.chunks = chunks
        self.scenes = sorted(scenes, key=lambda scene: scene.event.i)
        self.context = context
        self.draft = context.draft
        self.mentions = [c for c in chunks if isinstance(c, Mention)]
        self.subs = [c for c in chunks if isinstance(c, Term) and c.cat == "sub"]
        self.found = Happenings()
        self._marks = [k for k, token in enumerate(self.tokens) if token.low in _ENDS]
        self._said: dict[str, list[str]] = {}
        self._text = self.low(0, len(self.tokens))
        self._words = frozenset(token.low for token in self.tokens)

    def bounds(self, i: int) -> tuple[int, int]:
        """Where the sentence of a token begins and ends."""
        k = bisect_left(self._marks, i)
        start = self._marks[k - 1] + 1 if k else 0
        return start, self._marks[k] if k < len(self._marks) else len(self.tokens)

    def within(self, start: int, end: int) -> list[Clause]:
        """What happens between two tokens, participles before nouns left out."""
        return [s for s in self.scenes if start <= s.event.i < end and s.event.premod_of is None]

    def acts(self, start: int, end: int, kinds: Collection[ActKind] = ANY) -> list[Doing]:
        """The acts of some kinds that are first told of between two tokens."""
        return [a for a in self.found.acts if start <= a.i < end and a.kind in kinds]

    def spoken_of(self, start: int, end: int) -> list[Entity]:
        """Who is named between two tokens, in the order of the text."""
        return [e for m in self.mentions if start <= m.i < end for e in m.entities]

    def low(self, i: int, j: int) -> str:
        """The words of some tokens, with a blank at either end."""
        return f" {' '.join([t.low for t in self.tokens[max(0, i) : j]])} "

    def find(self, name: str, start: int, end: int) -> tuple[int, int] | None:
        """Where the first phrase of a list stands whole between two tokens."""
        if name not in self._said:
            near = self._words.intersection(_openings(name))
            said = [p for word in near for p in _openings(name)[word] if f" {p} " in self._text]
            self._said[name] = sorted(said, key=lambda p: (-len(p), p))
        phrases = self._said[name]
        text = self.low(start, end) if phrases else ""
        for phrase in phrases:
            at = text.find(f" {phrase} ")
            if at >= 0:
                first = max(0, start) + text[:at].count(" ")
                return first, first + phrase.count(" ") + 1
        return None

    def named(self, noun: NounPhrase | None) -> list[Entity]:
        """Whom a noun means, or whose part it is ("the ego's front")."""
        if noun is None:
            return []
        return list(noun.entities) if isinstance(noun, Mention) else noun.owned_by

    def add(self, doing: Doing) -> Doing:
        """One more act, at its place in the order of the text."""
        self.found.acts = sorted([*self.found.acts, doing], key=lambda a: a.i)
        return doing

    def same(self, model: Doing, entity: Entity, i: int, basis: Basis) -> Doing:
        """What somebody else does, done by this one too."""
        return self.add(Doing(model.kind, entity, basis, i, always=model.always))

    def stand(self, one: Entity, other: Entity) -> list[tuple[Entity, set[Approach]]]:
        """What is said of where one of two is, seen from the other."""
        said = ((p, {p.entity, p.reference or self.ego}) for p in self.draft.placements)
        return [(p.entity, p.approaches) for p, pair in said if pair == {one, other}]

    def in_file(self, one: Entity, other: Entity) -> tuple[Entity, Entity]:
        """Two as follower and leader: a headway is that of the one behind."""
        for entity, approaches in self.stand(one, other):
            if approaches in ({Approach.AHEAD}, {Approach.BEHIND}):
                rest = other if entity is one else one
                return (rest, entity) if approaches == {Approach.AHEAD} else (entity, rest)
        return (one, other) if one.ego or not other.ego else (other, one)

    def counterpart(self, entity: Entity, near: list[Entity]) -> Entity | None:
        """The other of two: for everybody the ego; for the ego who is ahead, or the only other.

        ``near``: who is spoken of around, the nearest last.
        """
        if entity is not self.ego:
            return self.ego
        others = [e for e in self.draft.entities if e is not entity]
        named = [e for e in reversed(near) if e in others]
        placed = self.context.placed
        ahead = [e for e in others if placed(e, Approach.AHEAD) or "ahead" in e.dirs | e.loci]
        farther = [e for e in ahead for o in ahead if (e, {Approach.AHEAD}) in self.stand(e, o)]
        ahead = [e for e in ahead if e not in farther] or ahead  # "a bus drives ahead of the van"
        moving = [e for e in ahead if e.stands is None and not e.parked]
        free = [e for e in others if not e.parked]
        by_name = ([e for e in named if e in some] for some in (moving, ahead))
        chosen = (*by_name, named, moving, ahead, free, others if len(others) == 1 else [])
        return next((choice[0] for choice in chosen if choice), None)
