"""What is not met is told with the reason that comes most often, and one scenario to look at."""

from scegen.campaign.report.unmet import CHECKS, FAILURES, STATEMENTS, TARGETS, Unmet, unmet


def row(description="d", status="made", **told):
    nothing = {"claims_missed": [], "check_findings": [], "reached": True, "blocked_by": None}
    return {"description": description, "status": status} | nothing | told


def test_everything_that_is_not_met_is_there_once():
    far = "blocked by the van is in time in 1,662 candidates within what is realistic"
    rows = [
        row(),
        row(claims_missed=["the gap is 20 m: 25 m"], reached=False),
        row("e", claims_missed=["the gap is 20 m: 30 m"], blocked_by=far),
        row("e", claims_missed=["the gap is 20 m: 31 m"], blocked_by=far.replace("1,662", "12")),
        row(reached=False, target="near-miss"),
        row(reached=None, target=None),
        row(check_findings=["schema: road, 3: no such thing [xsd.element]"]),
        row(status="failed", stage="enumerate", reason="no scenario\n  is as asked for"),
    ]
    found = unmet(rows)
    assert list(found) == [STATEMENTS, TARGETS, CHECKS, FAILURES]
    assert found[STATEMENTS] == [
        Unmet("the gap is 20 m", "blocked by the van is in time", 3, 2, example=2)
    ]
    assert found[TARGETS] == [
        Unmet("near-miss", "nothing is known that stands against it", 1, 1, 4)
    ]
    (check,) = found[CHECKS]
    assert (check.what, check.example) == ("schema: xsd.element", 6)
    assert found[FAILURES] == [Unmet("no scenario\n  is as asked for", "to enumerate it", 1, 1, 7)]


def test_where_all_is_met_nothing_is_told():
    assert unmet([row(), row(reached=None)]) == {}
