"""scegen understand --report and scegen benchmark understand, as a user runs them."""

import json

LABELLED = {
    "id": "x",
    "text": "A van brakes hard.",
    "expect": {
        "actors": {"van": [1, 1], "car": [1, 1]},
        "hazards": {"must": ["hard_braking"], "may": []},
    },
}


def test_the_report_is_plain_where_there_is_no_terminal(scegen):
    done = scegen("understand", "A purplish van turns left at a crossroads.", "--report")
    assert done.returncode == 0, done.stderr
    lines = done.stdout.splitlines()
    assert lines[0] == "A purplish van turns left at a crossroads."
    assert "\x1b" not in done.stdout
    rows = [line.split("\t") for line in lines[3:]]
    assert all(len(row) == 5 for row in rows)
    assert ["understood", "participants.van_1.maneuvers", "left", "turns left", "-"] in rows
    assert ["unsupported", "-", "-", "purplish", "not understood, ignored"] in rows


def test_the_report_as_json(scegen):
    done = scegen("understand", "A van turns left at a crossroads.", "--report", "--json")
    data = json.loads(done.stdout)
    assert data["text"] == "A van turns left at a crossroads."
    assert data["counts"]["understood"] == sum(
        f["standing"] == "understood" for f in data["findings"]
    )


def test_a_contradiction_is_shown_and_fails(scegen):
    done = scegen("understand", "The ego turns left and the ego turns right.", "--report")
    assert done.returncode == 2
    assert "contradicted\t-\t-\tturns left" in done.stdout
    assert "contradictory maneuvers" in done.stderr


def test_what_is_not_about_traffic_is_said_to_be_so(scegen):
    for options, words in (((), "not about traffic"), (("--json",), '"traffic": false')):
        done = scegen("understand", "The cat sleeps on the sofa.", "--report", *options)
        assert done.returncode == 2
        assert words in done.stdout
        assert "does not describe a traffic situation" in done.stderr


def test_scores_of_a_labelled_file(scegen, tmp_path):
    path = tmp_path / "cases.jsonl"
    path.write_text(json.dumps(LABELLED) + "\n")
    done = scegen("benchmark", "understand", path)
    assert done.returncode == 0, done.stderr
    assert "understood  1/1 (100.0 %)" in done.stdout
    wrong = LABELLED | {"id": "y", "expect": {"actors": {"bus": [1, 1]}}}
    path.write_text(json.dumps(LABELLED) + "\n" + json.dumps(wrong) + "\n")
    done = scegen("benchmark", "understand", path, "--json")
    assert done.returncode == 1
    data = json.loads(done.stdout)
    assert (data["cases"], data["understood"]) == (2, 1)
    assert data["hazards"]["all"]["f1"] == 1.0
    assert [f["case"] for f in data["failures"]] == ["y"]
