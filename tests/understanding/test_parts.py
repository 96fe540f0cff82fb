import pytest

from scegen.errors import InputError
from scegen.understanding import load_cases
from scegen.understanding.clauses.clauses import ClauseReader
from scegen.understanding.phrases.chunking import Chunker
from scegen.understanding.words.lemmas import lemmas
from scegen.understanding.words.numbers import number_at
from scegen.understanding.words.quantities import quantity_at
from scegen.understanding.words.tagging import tag
from scegen.understanding.words.tokens import tokenize


def events(text):
    tokens = tokenize(text)
    found = ClauseReader(Chunker(tag(tokens), tokens).run()).run()

    def words(mention):
        return " ".join(t.low for t in tokens[mention.i : mention.j])

    return [(e.name, [words(m) for m in e.subject]) for e in found if e.control is None]


@pytest.mark.parametrize(
    ("word", "base", "form"),
    [
        ("turning", "turn", "ing"),
        ("stopped", "stop", "ed"),
        ("approaches", "approach", "s"),
        ("braking", "brake", "ing"),
        ("drove", "drive", "ed"),
        ("lorries", "lorry", "s"),
    ],
)
def test_lemmas(word, base, form):
    assert (base, form) in lemmas(word)


@pytest.mark.parametrize("word", ["is", "as", "us", "bus"])
def test_short_words_keep_their_s(word):
    assert lemmas(word)[0] == (word, "base")
    assert all(base in {word, "bus"} for base, _ in lemmas(word))


@pytest.mark.parametrize(
    ("text", "value"), [("ten", 10), ("twenty-five", 25), ("1,000", 1000), ("2.5", 2.5)]
)
def test_numbers(text, value):
    number = number_at(tokenize(text), 0)
    assert number is not None
    assert number.value == value


@pytest.mark.parametrize(
    ("text", "low", "high"),
    [
        ("36 km/h", 10, 10),
        ("36 to 72 km/h", 10, 20),
        ("36 km/h to 72 km/h", 10, 20),
        ("36kph", 10, 10),
    ],
)
def test_speeds(text, low, high):
    quantity = quantity_at(tokenize(text), 0)
    assert quantity is not None
    assert quantity.value.low == pytest.approx(low)
    assert quantity.value.high == pytest.approx(high)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("A van tries to merge.", [("merge", ["a van"])]),
        ("While turning, the van stops.", [("turn", ["the van"]), ("stop", ["the van"])]),
        (
            "A bus stops, causing a taxi to swerve and brake.",
            [("stop", ["a bus"]), ("swerve", ["a taxi"]), ("brake", ["a taxi"])],
        ),
        ("The van behind the bus brakes.", [("brake", ["the van"])]),
        ("A van, which is slow, turns.", [("turn", ["a van"])]),
        ("A van overtakes a bus turning left.", [("overtake", ["a van"]), ("turn", ["a bus"])]),
        ("A van and a bus brake.", [("brake", ["a van", "a bus"])]),
    ],
)
def test_subjects(text, expected):
    assert events(text) == expected


def test_broken_label_files_name_the_line(tmp_path):
    path = tmp_path / "cases.jsonl"
    path.write_text('{"id": "x", "text": "y", "expect": {}}\nnonsense\n')
    with pytest.raises(InputError, match=r"cases\.jsonl:2"):
        load_cases(path)
    with pytest.raises(InputError, match="cannot be read"):
        load_cases(tmp_path / "missing.jsonl")
    path.write_text('{"id": "x", "text": "y", "expect": {}}\n' * 2)
    with pytest.raises(InputError, match=r"cases\.jsonl:2: another line has the id 'x'"):
        load_cases(path)
