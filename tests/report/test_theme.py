"""The colours: told apart by everybody, readable, the same in Python and CSS."""

import re
from dataclasses import fields
from itertools import combinations

import numpy as np
import pytest

from scegen.report.theme import DARK, LIGHT, THEMES, css

# Machado, Oliveira, Fernandes 2009, severity 1.0, on linear RGB.
SEEN_BY = {
    "everybody": np.eye(3),
    "protanopes": np.array(
        [
            [0.152286, 1.052583, -0.204868],
            [0.114503, 0.786281, 0.099216],
            [-0.003882, -0.048116, 1.051998],
        ]
    ),
    "deuteranopes": np.array(
        [
            [0.367322, 0.860646, -0.227968],
            [0.280085, 0.672501, 0.047413],
            [-0.011820, 0.042940, 0.968881],
        ]
    ),
    "tritanopes": np.array(
        [
            [1.255528, -0.076749, -0.178779],
            [-0.078411, 0.930809, 0.147602],
            [0.004733, 0.691367, 0.303900],
        ]
    ),
}


def linear(colour):
    channels = np.array([int(colour[i : i + 2], 16) for i in (1, 3, 5)]) / 255
    return np.where(channels <= 0.04045, channels / 12.92, ((channels + 0.055) / 1.055) ** 2.4)


def oklab(rgb):
    lms = np.cbrt(
        np.array(
            [
                [0.4122214708, 0.5363325363, 0.0514459929],
                [0.2119034982, 0.6806995451, 0.1073969566],
                [0.0883024619, 0.2817188376, 0.6299787005],
            ]
        )
        @ np.clip(rgb, 0, 1)
    )
    return (
        np.array(
            [
                [0.2104542553, 0.7936177850, -0.0040720468],
                [1.9779984951, -2.4285922050, 0.4505937099],
                [0.0259040371, 0.7827717662, -0.8086757660],
            ]
        )
        @ lms
    )


def contrast(one, other):
    dark, light = sorted(float(linear(c) @ [0.2126, 0.7152, 0.0722]) for c in (one, other))
    return (light + 0.05) / (dark + 0.05)


@pytest.mark.parametrize("seen_by", SEEN_BY)
@pytest.mark.parametrize("name", THEMES)
def test_the_ego_and_ten_others_differ_for_everybody(name, seen_by):
    theme = THEMES[name]
    seen = [oklab(SEEN_BY[seen_by] @ linear(c)) for c in (theme.ego, *theme.participants)]
    assert len(theme.participants) == 10
    least = 0.16 if seen_by == "everybody" else 0.08  # 0.02 is just seen
    assert min(np.linalg.norm(a - b) for a, b in combinations(seen, 2)) > least


@pytest.mark.parametrize("name", THEMES)
def test_words_can_be_read_and_bodies_seen(name):
    theme = THEMES[name]
    written = [
        (ink, paper)
        for ink in (theme.text, theme.text_soft, theme.accent, theme.hazard)
        for paper in (theme.background, theme.panel)
    ]
    written += [
        (getattr(theme, w), getattr(theme, f"{w}_wash")) for w in ("held", "failed", "open")
    ]
    standings = ("understood", "inferred", "assumed", "contradicted", "unsupported")
    written += [(theme.text, getattr(theme, word)) for word in standings]
    assert all(contrast(*pair) >= 4.5 for pair in written), [
        (*pair, contrast(*pair)) for pair in written if contrast(*pair) < 4.5
    ]
    bodies = (theme.ego, *theme.participants)
    assert all(contrast(body, theme.road) > 1.2 for body in bodies)
    assert all(contrast(body, theme.panel) > 1.75 for body in bodies)


def test_css_has_every_colour_of_both_variants():
    found = re.findall(r"(--[a-z0-9-]+): (#[0-9a-f]{6});", css())
    properties = [theme.properties() for theme in (LIGHT, DARK, DARK)]
    assert found == [pair for colours in properties for pair in colours.items()]
    assert len(properties[0]) == len(fields(LIGHT)) - 2 + len(LIGHT.participants)


def test_colours_go_to_names_in_turn():
    many = [f"car_{i}" for i in range(12)]
    colours = LIGHT.colours([*many, "me"], "me")
    assert colours["me"] == LIGHT.ego
    assert [colours[n] for n in many[:10]] == list(LIGHT.participants)
    assert colours["car_10"] == LIGHT.participants[0]
