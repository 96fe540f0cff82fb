"""The text cut into passages: nothing lost, nothing twice, trouble first."""

from hypothesis import given
from hypothesis import strategies as st

from scegen.understanding import Finding, ParseReport, Standing, parse_report, passages

TEXT = "In rain a purplish van turns left at a crossroads; several buses wait in snow."


def shown(text):
    report = parse_report(text)
    return [(report.text[s.start : s.end], s.standing) for s in passages(report) if s.standing]


def test_words_inside_a_phrase_keep_their_standing():
    found = shown(TEXT)
    assert ("a ", Standing.UNDERSTOOD) in found
    assert ("purplish", Standing.UNSUPPORTED) in found
    assert (" van", Standing.UNDERSTOOD) in found
    assert ("snow", Standing.CONTRADICTED) in found
    assert ("several buses", Standing.INFERRED) in found


def test_both_sides_of_a_contradiction_are_shown_as_the_text_has_them():
    assert shown("A T-intersection with five arms.") == [
        ("T-intersection", Standing.CONTRADICTED),
        ("five arms", Standing.CONTRADICTED),
    ]


def test_all_that_rests_on_the_same_words_is_told_together():
    report = parse_report("A van turns left at a T-junction.")
    (junction,) = (s for s in passages(report) if report.text[s.start : s.end] == "T-junction")
    assert {"junction.kind", "junction.arms"} <= {f.field for f in junction.findings}


PLACES = st.tuples(st.sampled_from(Standing), st.integers(-3, 90), st.integers(-3, 90))


@given(st.text(max_size=80), st.lists(PLACES))
def test_the_passages_are_the_text(text, places):
    findings = tuple(Finding(s, "f", start=a, end=b) for s, a, b in places)
    found = passages(ParseReport(text, findings))
    assert "".join(text[s.start : s.end] for s in found) == text
    assert all(s.start < s.end for s in found)
    for passage in found:
        here = [f for f in findings if f.start <= passage.start and passage.end <= f.end]
        assert list(passage.findings) == here
        assert (passage.standing is None) == (not here)
