"""The careful driver's verdict and the reactivity, in words and rows."""

from scegen.criticality.careful_driver import Outcome, Verdict
from scegen.criticality.reactivity.sensitivity import Sensitivity, Start
from scegen.report.judgement import judgement_tables, verdict_words


def verdict(**changes) -> Verdict:
    fields = {
        "outcome": Outcome.AVOIDABLE,
        "contact_as_driven": ("car_2",),
        "danger": "car_2",
        "perceived_s": 1.0,
        "brakes_s": 2.15,
        "contact": (),
        "secondary": (),
        "distance_m": 1.25,
        "contact_speed_mps": None,
        "spare_s": 0.3,
    }
    return Verdict(**(fields | changes))


def test_verdicts_in_words():
    words = verdict_words(verdict(secondary=("van",)))
    for part in (
        "would not touch car_2",
        "from 1.00 s",
        "at 2.15 s",
        "1.25 m",
        "0.3 s later",
        "van",
    ):
        assert part in words
    hit = verdict(
        outcome=Outcome.UNAVOIDABLE, contact=("car_2",), contact_speed_mps=4.0, spare_s=-0.6
    )
    words = verdict_words(hit)
    for part in ("would touch car_2", "4.0 m/s", "0.6 s earlier"):
        assert part in words
    assert "0.00 m" not in words
    quiet = verdict(
        contact_as_driven=(), danger=None, perceived_s=None, brakes_s=None, spare_s=None
    )
    assert "No danger ahead" in verdict_words(quiet)


def test_the_tables_say_what_a_careful_driver_and_another_start_change():
    starts = [Start(f, f > 0.9, 0.0 if f > 0.9 else 12.0, None, None) for f in (1.0, 0.8, 1.2)]
    avoidable, reactive = judgement_tables(verdict(), Sensitivity("car_2", *starts))
    assert "avoidable" in avoidable.rows[0][0]
    assert "our extension" in avoidable.rows[0][2]
    assert "does not always stay critical" in reactive.title
    assert [(row[0], row[-1]) for row in reactive.rows] == [
        ("−20 %", "no"),
        ("as it is", "yes"),
        ("+20 %", "yes"),
    ]
    assert judgement_tables(None, None) == []
