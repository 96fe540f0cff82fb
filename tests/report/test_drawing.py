"""The drawing layer: valid, escaped, short, the same letters on every machine."""

from io import BytesIO

import numpy as np
from hypothesis import example, given
from hypothesis import strategies as st
from lxml import etree
from PIL import Image

from scegen.report.drawing import areas, box, document, element, letters, line, number
from scegen.report.raster import png_of, text_width, wrapped


@given(st.floats(-1e6, 1e6))
def test_numbers_are_short_and_right(value):
    assert abs(float(number(value)) - value) <= 0.00501
    assert "e" not in number(value)
    assert number(value) != "-0"


@example("\ufffe and \uffff")
@given(st.text(st.characters(exclude_categories=("Cs", "Cc")), max_size=30))
def test_anything_said_is_escaped(words):
    text = document(10, 10, letters(words, 1, 1, 9, words), title=words, describes=words)
    root = etree.fromstring(text.encode())
    written = [node.text or "" for node in root]
    legal = words.replace("\ufffe", "").replace("\uffff", "")  # XML has no place for these
    assert written[-1] == legal
    assert root[-1].get("fill") == legal


def test_what_is_none_is_left_out_and_nothing_draws_nothing():
    assert element("g", stroke_width=None, class_="a") == '<g class="a"/>'
    assert areas([], "#000000") == ""


def test_letters_need_no_fonts_of_the_system():
    empty, word = (
        np.asarray(Image.open(BytesIO(png_of(document(60, 20, drawn)))))
        for drawn in (box(0, 0, 1, 1, "none"), letters("→ 5 m/s²", 2, 15, 12, "#000000"))
    )
    assert (empty[..., 3] > 0).sum() == 0
    assert (word[..., 3] > 0).sum() > 100
    assert png_of(document(60, 20, line([(0, 0), (9, 9)], "red", 1)), 2.0)[:4] == b"\x89PNG"


def test_words_are_as_wide_as_they_are_drawn():
    for words, bold in (("closest approach, 9.8 s", False), ("car_10 130 km/h", True)):
        drawn = letters(words, 0, 30, 20, "#000000", bold=bold)
        image = np.asarray(Image.open(BytesIO(png_of(document(400, 40, drawn)))))
        inked = np.flatnonzero(image[..., 3].any(axis=0))
        assert abs(text_width(words, 20, bold=bold) - inked[-1]) < 4


@given(st.text("ab c", min_size=1, max_size=200), st.floats(40, 300))
def test_wrapped_rows_fit_and_lose_nothing_but_the_end(words, width):
    rows = wrapped(words, 12, width, most=3)
    assert len(rows) <= 3
    single = max((text_width(w, 12) for w in words.split()), default=0)
    if single <= width:
        assert all(text_width(row, 12) <= width for row in rows)
    joined = " ".join(rows).removesuffix(" …")
    assert " ".join(words.split()).startswith(joined.rstrip())
