"""Plots show all values between round numbers; one that lies far out does not flatten the rest."""

import re

import numpy as np
import pytest

from scegen.campaign.report.charts import histogram


def numbers(drawn):
    return re.findall(r"<text[^>]*>([-\d.,+]+)</text>", drawn)


@pytest.mark.parametrize(
    ("values", "ticks"),
    [
        ([0.1, 0.9], ["0", "0.2", "0.4", "0.6", "0.8", "1"]),
        ([2.78, 16.67], ["0", "5", "10", "15", "20"]),
        ([3.0], ["3", "3.5", "4"]),
        ([-1.3, np.nan, 5.0], ["-2", "0", "2", "4", "6"]),
    ],
)
def test_ticks_are_round(values, ticks):
    found = numbers(histogram("Gap", "m", np.array(values)))
    assert found[-len(ticks) :] == ticks
    assert all(float(count).is_integer() for count in found[: -len(ticks)])


def test_far_values_are_in_the_last_bar():
    values = np.array([1.0] * 10 + [2.0] * 10 + [400.0] * 3)
    found = numbers(histogram("TTC", "s", values, critical=1.5))
    assert found[-1] == "8+"
    assert "10" in found


def test_without_values_there_is_no_plot():
    assert histogram("TTC", "s", np.array([np.nan, np.inf])) == ""
