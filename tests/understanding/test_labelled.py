"""The labelled descriptions: the paper's come with the package, the others lie beside it."""

from pathlib import Path

import pytest

from scegen.understanding import load_cases, paper_cases, read, score

OWN = Path(__file__).with_name("own_descriptions.jsonl")
BESIDE = Path(__file__).resolve().parents[3] / "shared" / "descriptions" / "development.jsonl"


def test_the_paper_has_eleven_sentences():
    assert len(paper_cases()) == 11


@pytest.mark.parametrize("case", paper_cases(), ids=lambda case: case.id)
def test_every_sentence_of_the_paper_is_understood(case):
    assert score(case.expect, read(case.text)).problems == ()


def test_sentences_of_our_own_in_many_manners():
    """Reports, protocols, plain talk; labels were written before the reader saw the sentences."""
    cases = load_cases(OWN)
    failed = {c.id: score(c.expect, read(c.text)).problems for c in cases}
    failed = {name: problems for name, problems in failed.items() if problems}
    assert len(failed) <= 0.03 * len(cases), failed


def test_labelled_descriptions_beside_the_checkout():
    if not BESIDE.exists():
        pytest.skip("no labelled descriptions lie beside the checkout")
    cases = load_cases(BESIDE)
    failed = {c.id: score(c.expect, read(c.text)).problems for c in cases}
    failed = {name: problems for name, problems in failed.items() if problems}
    assert len(failed) <= 0.05 * len(cases), failed
