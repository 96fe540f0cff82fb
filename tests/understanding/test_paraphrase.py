"""Laws of paraphrase over made-up sentences: order, voice, mirror, digits, idle words."""

import re

from hypothesis import given
from hypothesis import strategies as st

from scegen.understanding import read

KINDS = {"bus": "bus", "van": "van", "lorry": "truck", "motorbike": "motorcycle", "taxi": "car"}
SIDES = {"left": "right", "right": "left"}
NUMBERS = {1: "one", 2: "two", 3: "three", 4: "four", 5: "five"}

kind = st.sampled_from(sorted(KINDS))
side = st.sampled_from(sorted(SIDES))
count = st.integers(2, 5)
LOCI = {"behind": "behind", "in front of": "ahead", "beside": "adjacent"}
locus = st.sampled_from(sorted(LOCI))
idle = st.sampled_from(
    ["", "On a sunny day, ", "In this scenario, ", "At night, ", "It is raining. ", "Note: "]
)


def seen(text):
    """Kind, position and movement of everybody but the ego, and the hazards."""
    scenario = read(text)
    others = sorted(
        (p.kind.value, *sorted(map(str, p.approaches)), *sorted(map(str, p.maneuvers)))
        for p in scenario.participants
        if p.role != "ego"
    )
    return others, sorted({h.kind.value for h in scenario.hazards})


def mirrored(text):
    return re.sub(r"\b(left|right)\b", lambda m: SIDES[m.group()], text)


@given(kind, locus, idle)
def test_word_order_does_not_matter(who, where, before):
    said = seen(f"{before}There is a {who} {where} the ego.")
    inverted = seen(f"{before}{where.capitalize()} the ego is a {who}.")
    existential = seen(f"{before}{where.capitalize()} the ego there is a {who}.")
    assert said == inverted == existential
    assert said[0] == [(KINDS[who], LOCI[where], "straight")]


@given(kind, side, idle)
def test_a_subject_may_follow_its_verb(who, way, before):
    plain = seen(f"{before}A {who} comes from the {way} and the ego waits at a junction.")
    inverted = seen(f"{before}From the {way} comes a {who} and the ego waits at a junction.")
    assert plain == inverted


@given(kind, kind)
def test_active_and_passive_say_the_same(one, other):
    active = read(f"A {one} overtakes a {other}.")
    passive = read(f"A {other} is overtaken by a {one}.")
    for scenario in (active, passive):
        (hazard,) = scenario.hazards
        names = {p.id: p.kind.value for p in scenario.participants}
        assert (hazard.kind, [names[n] for n in hazard.by]) == ("overtaking", [KINDS[one]])
        assert [names[n] for n in hazard.to] == [KINDS[other]]


@given(kind, kind, side, side)
def test_a_mirrored_text_is_a_mirrored_scenario(one, other, way, turn):
    text = f"At a junction a {one} from the {way} of the ego turns {turn} and a {other} waits."
    others, hazards = seen(text)
    swapped, same = seen(mirrored(text))
    assert sorted(tuple(sorted(SIDES.get(w, w) for w in o)) for o in others) == sorted(
        tuple(sorted(o)) for o in swapped
    )
    assert hazards == same


@given(kind, count, side)
def test_digits_are_words(who, number, way):
    plural = {"bus": "buses", "lorry": "lorries"}.get(who, f"{who}s")
    spoken = seen(f"{NUMBERS[number].capitalize()} {plural} come from the {way} of the ego.")
    assert spoken == seen(f"{number} {plural} come from the {way} of the ego.")
    assert len(spoken[0]) == number


@given(kind, kind, idle)
def test_a_verb_may_be_left_out(one, other, before):
    full = seen(f"{before}At a junction a {one} turns left and a {other} turns right.")
    assert full == seen(f"{before}At a junction a {one} turns left and a {other} right.")


@given(kind, side)
def test_near_and_far_swap_with_the_driving_side(who, way):
    near = "nearside" if way == "right" else "farside"
    far = "farside" if way == "right" else "nearside"
    text = f"A child crosses from the {{}} in front of a {who} and the ego."
    assert seen(text.format(near)) == seen(text.format(way))
    left_hand = text + " Traffic drives on the left."
    assert seen(left_hand.format(far)) == seen(left_hand.format(way))


@given(st.sampled_from(["Nobody was hurt.", "The road is dry.", "It was a Tuesday."]), kind)
def test_idle_sentences_change_nothing(idle_sentence, who):
    text = f"The ego follows a {who}, which brakes hard."
    assert seen(f"{text} {idle_sentence}") == seen(text)


ADVERBS = ["also", "too", "now", "still", "just", "even", "then", "as well", "on its own"]
ADVERBS += ["meanwhile", "in turn", "once more", "without warning", "all of a sudden"]
SUBJECTS = ["the lead vehicle", "the {kind} in front", "the {kind} ahead", "a {kind} from the left"]
SUBJECTS += ["the ego follows a {kind}, which", "the {kind} in the left lane"]


@given(
    st.sampled_from(SUBJECTS), st.sampled_from(ADVERBS), kind, st.sampled_from(["brakes", "stops"])
)
def test_an_adverb_before_a_verb_does_not_hide_it(subject, adverb, who, does):
    subject = subject.format(kind=who)
    acts = [act.kind for act in read(f"{subject.capitalize()} {does}.").acts]
    assert acts == [act.kind for act in read(f"{subject.capitalize()} {adverb} {does}.").acts]
    assert len(acts) == 1
