"""The offline reader: English text to a functional scenario, by rules and a lexicon."""

from collections.abc import Callable

from scegen.errors import InputError
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.junction import ARM_COUNTS
from scegen.scenario.vocabulary import DrivingSide, JunctionKind
from scegen.understanding.amounts.reading import read_amounts
from scegen.understanding.building.building import Builder
from scegen.understanding.building.choosing_ego import choose_ego
from scegen.understanding.building.coverage import unattached, undone
from scegen.understanding.building.leftovers import left_out, report
from scegen.understanding.chunks import Chunk
from scegen.understanding.clauses.clauses import ClauseReader
from scegen.understanding.clauses.coordination import share_out
from scegen.understanding.clauses.ellipsis import (
    fill_in,
    named_again,
    names_another,
)
from scegen.understanding.clauses.located import who_comes
from scegen.understanding.draft import Draft
from scegen.understanding.frames import Numbers
from scegen.understanding.meaning.lights import read_calls
from scegen.understanding.meaning.manner import too_fast
from scegen.understanding.meaning.meaning import interpret
from scegen.understanding.meaning.roadside import name_hiders
from scegen.understanding.phrases.chunking import Chunker
from scegen.understanding.phrases.headings import announce, read_entries, silence
from scegen.understanding.phrases.listed import each_of, in_between, list_them
from scegen.understanding.phrases.naming import counted_in, filmed_from, in_brackets, under_test
from scegen.understanding.phrases.opening_doors import open_doors
from scegen.understanding.phrases.repeated import lanes_meant, repeat, which_is_it
from scegen.understanding.phrases.telegrams import spell_out
from scegen.understanding.phrases.touching import counted_from
from scegen.understanding.phrases.which_road import name_roads, name_turned_into
from scegen.understanding.reference.generic import answer, deny_of_everybody
from scegen.understanding.reference.own_vehicles import whole_for_part
from scegen.understanding.reference.resolving import resolve_mentions
from scegen.understanding.reference.roster import Roster
from scegen.understanding.road.each_arm import count_arms, share_arms
from scegen.understanding.road.junctions import JunctionReading, read_junction
from scegen.understanding.road.lengthwise import read_lengthwise, whole_bends
from scegen.understanding.road.surroundings import read_surroundings
from scegen.understanding.semantics.context import Context
from scegen.understanding.semantics.rows import say
from scegen.understanding.semantics.seen import settle_far_sides
from scegen.understanding.words.asides import tag_known
from scegen.understanding.words.emptiness import without_emptiness
from scegen.understanding.words.places import count_places, settle_sides
from scegen.understanding.words.refusing import require_english, require_traffic
from scegen.understanding.words.tokens import Token, tokenize

MAX_CHARACTERS = 20_000
"""Longer texts are no descriptions of one situation."""
_ASSUMED_ARMS = 4
_PUT_RIGHT: tuple[tuple[set[str], Callable[[list[Chunk], list[Token]], list[Chunk]]], ...] = (
    ({"width", "breadth"}, counted_from),
    ({"lane", "lanes", "ramp", "one"}, lanes_meant),
    ({"behind", "between", "by"}, lambda chunks, _: name_hiders(chunks)),
    (set(), name_roads),
    ({"ahead", "behind"}, whole_for_part),
    ({"turn", "sharp_turn"}, name_turned_into),
    ({"which", "whom", "that", "where"}, which_is_it),
    ({"including", "included", "among", "amongst"}, counted_in),
    (set(), filmed_from),
    (set(), under_test),
    ({"("}, lambda chunks, _: in_brackets(chunks)),
    ({":"}, lambda chunks, _: read_entries(chunks)),
    ({"one", "all", "both", "neither", "none"}, lambda chunks, _: each_of(chunks)),
    ({"between"}, lambda chunks, _: in_between(chunks)),
    ({"num"}, list_them),
    ({":"}, lambda chunks, _: announce(chunks)),
    (set(), lambda chunks, _: spell_out(chunks)),
    (set(), lambda chunks, _: silence(chunks)),
    (set(), repeat),
    ({"door"}, open_doors),
)
"""What puts chunks right one after the other, and words or classes of which a text
needs one, if any are told."""


def read(text: str) -> FunctionalScenario:
    """Reads a description of a traffic situation.

    The same text always gives the same scenario; nothing is sent anywhere.

    Args:
        text: one or several English sentences.

    Returns:
        What the text says, every field with the words that it rests on.

    Raises:
        InputError: if the text is empty, too long, or in another language than English.
        NotTrafficError: if it does not describe traffic.
        InfeasibleError: if what it describes cannot exist.
    """
    if not text.strip():
        msg = "the description is empty"
        raise InputError(
            msg,
            where="description",
            hint="Describe a traffic situation in a sentence, for example 'Two cars meet at a "
            "four-way intersection.'",
        )
    if any("\ud800" <= character <= "\udfff" for character in text):
        msg = "holds broken characters: it, or the terminal, is not in UTF-8"
        raise InputError(msg, where="description", hint="hand it in as a file in UTF-8")
    if len(text) > MAX_CHARACTERS:
        msg = f"the description has {len(text)} characters, more than {MAX_CHARACTERS}"
        raise InputError(msg, where="description", hint="Describe one situation at a time.")
    tokens = without_emptiness(tokenize(text))
    require_english(tokens, text)
    tokens, terms, strange = tag_known(text, tokens)
    terms = whole_bends(terms, tokens)
    require_traffic(terms, tokens)
    junction = read_junction(terms, tokens)
    surroundings = read_surroundings(terms, tokens)
    across = "right" if surroundings.side is DrivingSide.LEFT else "left"
    lengthwise = read_lengthwise(terms, across)
    terms = settle_sides(terms, surroundings.side)
    terms = count_places(terms, tokens)
    chunks = Chunker(terms, tokens).run()
    there = {t.low for t in tokens}.union(*((t.cat, t.value) for t in terms))
    for words, put_right in _PUT_RIGHT:
        if not words or not there.isdisjoint(words):
            chunks = put_right(chunks, tokens)
    events = fill_in(chunks, ClauseReader(chunks).run(), tokens)
    deny_of_everybody(events)
    answer(events, tokens)
    who_comes(chunks, events)
    named_again(events)
    names_another(events)
    draft = Draft(text, tokens)
    draft.ramp = lengthwise.auxiliary[1] if lengthwise.auxiliary is not None else None
    draft.kerb = (surroundings.side or DrivingSide.RIGHT).value
    shared = share_arms(chunks, events)
    resolve_mentions(chunks, events, Roster(draft, tokens, _arms(junction)))
    count_arms(shared, junction)
    events = share_out(events, terms)
    context = Context(draft, junction, tokens, across)
    numbers = Numbers(terms, tokens, surroundings.measured)
    scenes = interpret(chunks, events, context)
    settle_far_sides(draft)
    ego = choose_ego(draft, crossing=junction.crossing)
    happenings = read_amounts(numbers, chunks, scenes, context, ego[0])
    for scene in scenes:
        say("movements.runs", scene, context)
    limit_mps, _ = surroundings.road.get("speed_limit_mps", (None, None))
    too_fast(draft, limit_mps)
    read_calls(terms, draft)
    report(draft, terms, chunks, crossing=junction.crossing)
    scenario = Builder(draft, ego, happenings, junction, surroundings, lengthwise).build()
    return left_out(undone(unattached(scenario, terms, events, tokens), events, tokens), strange)


def _arms(junction: JunctionReading) -> int:
    """How many directions "all directions" are."""
    if junction.arms is not None:
        return junction.arms
    if junction.kind is None or junction.kind is JunctionKind.ROUNDABOUT:
        return _ASSUMED_ARMS
    return ARM_COUNTS[junction.kind][0]
