"""Each command does what its help says; stdout carries results only."""

import json
import shlex
import shutil
from pathlib import Path

import pytest
import yaml

from scegen.pipeline.command import command_line
from scegen.pipeline.generate import generate
from scegen.pipeline.options import Options
from scegen.pipeline.source import resolve_source

SENTENCE = (
    "The ego car turns left at a four-way intersection while an oncoming truck goes straight "
    "at 50 km/h and a pedestrian crosses the road."
)


def files(folder: Path) -> dict[str, bytes]:
    return {
        p.relative_to(folder).as_posix(): p.read_bytes() for p in folder.rglob("*") if p.is_file()
    }


@pytest.fixture(scope="module")
def made(tmp_path_factory):
    """The folder that generate makes from the sentence."""
    folder = tmp_path_factory.mktemp("made") / "out"
    generate(resolve_source(SENTENCE), folder, Options())
    return folder


def test_generate_makes_the_whole_folder(scegen, tmp_path, made):
    done = scegen("generate", SENTENCE, "-o", "out", process=True)
    assert done.returncode == 0, done.stderr
    top = {p.name for p in (tmp_path / "out").iterdir()}
    assert top == {
        "functional.yaml",
        "logical.json",
        "gallery.svg",
        "report.html",
        "summary.json",
        "scenarios",
    }
    (scenario,) = (tmp_path / "out" / "scenarios").iterdir()
    assert {p.name for p in scenario.iterdir()} == {
        "road.xodr",
        "scenario.xosc",
        "concrete.yaml",
        "preview.png",
        "proof.json",
    }
    assert scenario.name in done.stdout
    assert "report.html" in done.stderr
    # another process and another folder, the same bytes
    assert files(tmp_path / "out") == files(made)


def test_another_seed_gives_other_numbers(scegen, tmp_path, made):
    assert scegen("generate", SENTENCE, "-o", "out", "--seed", "7").returncode == 0
    (ours,) = (tmp_path / "out").glob("scenarios/*/scenario.xosc")
    (theirs,) = made.glob("scenarios/*/scenario.xosc")
    assert ours.parent.name == theirs.parent.name
    assert ours.read_bytes() != theirs.read_bytes()


def test_every_level_can_be_fed_back(scegen, tmp_path, made):
    for name in ("functional.yaml", "logical.json"):
        assert scegen("generate", made / name, "-o", name + ".out").returncode == 0
        again, first = files(tmp_path / (name + ".out")), files(made)
        summaries = [json.loads(folder.pop("summary.json")) for folder in (again, first)]
        assert [summary.pop("source") for summary in summaries] == [name, "functional.yaml"]
        assert summaries[0] == summaries[1]
        assert again == first


@pytest.mark.parametrize(
    ("source", "options"),
    [
        ("functional.yaml", ("--rules", "mine.lp", "--seed", "3", "--osc", "1.2")),
        ("concrete.yaml", ()),
        ("concrete.yaml", ("--target", "distance=1..3")),
    ],
)
def test_a_folder_tells_how_it_is_made_again(scegen, tmp_path, made, source, options):
    (tmp_path / "mine.lp").write_text(":- not turns(ego,left).\n")
    (given,) = made.rglob(source)
    assert scegen("generate", given, "-o", "out", "--check", "none", *options).returncode == 0
    out = tmp_path / "out"
    command = command_line(json.loads((out / "summary.json").read_text()), "again")
    words = [out / word if (out / word).is_file() else word for word in shlex.split(command)[1:]]
    assert scegen(*words).returncode == 0
    assert files(tmp_path / "again") == files(out)


def test_a_concrete_scenario_edited_by_hand_is_obeyed(scegen, tmp_path, made):
    (source,) = made.glob("scenarios/*/concrete.yaml")
    edited = yaml.safe_load(source.read_text())
    pedestrian = next(p for p in edited["participants"] if p["kind"] == "pedestrian")
    pedestrian["speed_program"][0]["target_speed_mps"] = 2.75
    (tmp_path / "edited.yaml").write_text(yaml.safe_dump(edited))
    done = scegen("generate", "edited.yaml", "-o", "out")
    assert done.returncode == 0, done.stderr
    (scenario,) = (tmp_path / "out").glob("scenarios/*/scenario.xosc")
    assert "2.75" in scenario.read_text()
    (before,) = made.glob("scenarios/*/scenario.xosc")
    assert "2.75" not in before.read_text()


def test_pick_and_count(scegen, tmp_path):
    text = "Three cars meet at a T-intersection."
    assert scegen("generate", text, "-o", "a", "--pick", "2,0", "--check", "none").returncode == 0
    names = sorted(p.name[:3] for p in (tmp_path / "a" / "scenarios").iterdir())
    assert names == ["000", "002"]
    assert scegen("generate", text, "-o", "b", "--count", "3", "--check", "none").returncode == 0
    assert len(list((tmp_path / "b" / "scenarios").iterdir())) == 3


def test_generate_json_is_the_summary(scegen, tmp_path):
    done = scegen("generate", SENTENCE, "-o", "out", "--json", "--check", "none")
    assert json.loads(done.stdout) == json.loads((tmp_path / "out" / "summary.json").read_text())


def test_the_12_variant(scegen, tmp_path):
    done = scegen("generate", SENTENCE, "-o", "out", "--osc", "1.2")
    assert done.returncode == 0, done.stderr
    (scenario,) = (tmp_path / "out").glob("scenarios/*/scenario.xosc")
    assert 'revMinor="2"' in scenario.read_text()


def test_understand_prints_a_level_that_loads(scegen, tmp_path):
    done = scegen("understand", SENTENCE)
    (tmp_path / "functional.yaml").write_text(done.stdout)
    again = scegen("understand", "functional.yaml", "--json")
    data = json.loads(again.stdout)
    assert data["description"] == SENTENCE
    assert data["junction"]["kind"] == "four_way"
    assert data == yaml.safe_load(done.stdout)


def test_enumerate_counts_and_lists_alike(scegen, made):
    counted = json.loads(
        scegen("enumerate", made / "functional.yaml", "--count-only", "--json").stdout
    )
    listed = json.loads(scegen("enumerate", made / "functional.yaml", "--json").stdout)
    assert len(listed["scenarios"]) == listed["count"] == counted["count"]
    assert listed["total"] == counted["total"] == sum(s["class_size"] for s in listed["scenarios"])


@pytest.mark.parametrize(("reduction", "count"), [("none", 27), ("pattern", 10), ("exact", 27)])
def test_enumerate_without_a_file(scegen, reduction, count):
    done = scegen(
        "enumerate", "--entries", "0,1,2", "--junction-arms", "4", "--arms", "equal",
        "--reduction", reduction, "--count-only", "--json",
    )  # fmt: skip
    data = json.loads(done.stdout)
    assert (data["total"], data["count"]) == (27, count)


def test_concretize_makes_a_level_that_generate_takes(scegen, tmp_path, made):
    done = scegen("concretize", made / "logical.json", "--index", "0", "-o", "concrete.yaml")
    assert done.returncode == 0, done.stderr
    plain = ("-o", "plain", "--pick", "0", "--target", "none", "--check", "none")
    assert scegen("generate", made / "logical.json", *plain).returncode == 0
    (theirs,) = (tmp_path / "plain").glob("scenarios/000-*/concrete.yaml")
    assert (tmp_path / "concrete.yaml").read_bytes() == theirs.read_bytes()


def test_check_passes_good_files_and_fails_broken_ones(scegen, tmp_path, made):
    assert scegen("check", made).returncode == 0
    shutil.copytree(made, tmp_path / "broken")
    (road,) = (tmp_path / "broken").glob("scenarios/*/road.xodr")
    road.write_text(road.read_text().replace("<elevation ", "<elevatio ", 1))
    done = scegen("check", "broken", "--json")
    assert done.returncode == 1
    (report,) = json.loads(done.stdout)
    assert report["ok"] is False
    assert any(f["severity"] == "error" for r in report["results"] for f in r["findings"])


def test_check_says_what_is_required_but_missing(scegen, made):
    done = scegen("check", made, "--require", "esmini", path="/usr/bin:/bin")
    assert done.returncode == 3
    assert "esmini" in done.stderr
    assert scegen("check", made, "--require", "oracle").returncode == 2


def test_play_says_how_to_get_esmini(scegen, made):
    done = scegen("play", made, path="/usr/bin:/bin")
    assert done.returncode == 3
    assert "github.com/esmini" in done.stderr


@pytest.mark.esmini
@pytest.mark.skipif(shutil.which("esmini") is None, reason="esmini is not on PATH")
def test_play_plays(scegen, made):
    done = scegen("play", made, "--headless")
    assert done.returncode == 0
    assert done.stdout.splitlines() == [f"{next(made.glob('scenarios/*/scenario.xosc'))}  played"]
    assert done.stderr == ""


def test_play_names_what_is_there(scegen, made):
    done = scegen("play", made, "--scenario", "no-such")
    assert done.returncode == 2
    assert "there are: 0" in done.stderr


@pytest.mark.parametrize("level", ["functional", "logical", "concrete"])
def test_schema_is_json_schema(scegen, level):
    assert "properties" in json.loads(scegen("schema", level).stdout)


def test_an_unknown_level_names_all_that_there_are(scegen):
    done = scegen("schema", "abstract")
    assert done.returncode == 2
    assert all(f"'{level}'" in done.stderr for level in ("functional", "concrete", "campaign"))


def test_doctor_names_every_tool(scegen):
    done = scegen("doctor", "--json", path="/usr/bin:/bin")
    tools = {tool["tool"]: tool for tool in json.loads(done.stdout)}
    assert tools["esmini"]["found"] is None
    assert "esmini" in tools["esmini"]["hint"]
    assert "missing  esmini" in scegen("doctor", path="/usr/bin:/bin").stdout


def test_a_target_that_is_none_is_refused(scegen, tmp_path):
    done = scegen("generate", SENTENCE, "-o", "out", "--target", "doom")
    assert done.returncode == 2
    assert "--target" in done.stderr
    assert not (tmp_path / "out").exists()


def test_a_failed_search_is_said_loudly_and_what_is_said_holds_all_the_same(scegen, tmp_path):
    text = "The ego turns left at a crossing while an oncoming car goes straight."
    done = scegen("generate", text, "-o", "out", "--target", "headway=0.01..0.02")
    assert done.returncode == 1, done.stderr
    assert "TARGET NOT REACHED" in done.stderr
    assert scegen("generate", text, "-o", "plain", "--target", "none").returncode == 0
    (plain,) = (tmp_path / "plain").glob("scenarios/*/concrete.yaml")
    assert not (plain.parent / "proof.json").exists()
    (made,) = json.loads((tmp_path / "out" / "summary.json").read_text())["scenarios"]
    assert made["danger"]["in_band"] is False
    assert made["danger"]["blocked_by"]
    assert made["claims"]["hold"] == made["claims"]["asked"]


IMPOSSIBLE = {
    "paths that never meet": (
        "Two cars drive on a straight road, one in the opposite direction.",
        "collision",
        1,
        "the paths of car_1 and car_2 never meet",
    ),
    "walking pace": (
        "Two cars meet at a four-way intersection with a speed limit of 1 m/s.",
        "pet=-0.1..0.1",
        1,
        "neither car_1 nor car_2 may go faster than 1 m/s here",
    ),
    "one value": (
        "Two cars meet at a four-way intersection with a speed limit of 1 m/s.",
        "pet=0..0",
        2,
        "a range needs a lower and a higher end",
    ),
    "500 m/s": (
        "A car drives at 500 m/s through a four-way intersection while another car crosses.",
        "near-miss",
        2,
        "car_1 is to go 500 m/s; a car reaches 60 m/s",
    ),
    "braking beyond physics": (
        "The ego follows a car. The car brakes with 100 m/s2.",
        "near-miss",
        2,
        "acts.brake_1.rate_mps2: car_1 is to brake with 100 m/s2, which nobody can Give more than "
        "0 and at most 20 m/s2.",
    ),
    "braking with nothing": (
        "The ego follows a car. The car brakes with 0 m/s2.",
        "near-miss",
        2,
        "car_1 is to brake with 0 m/s2, which nobody can",
    ),
    "off the road": (
        "The ego overtakes a car with a lateral gap of 50 m.",
        "near-miss",
        2,
        "what is told leads to offset_m: 52.16 is not allowed: it must be at most 12",
    ),
    "alone": (
        "The ego drives alone at a four-way intersection.",
        "collision",
        1,
        "nobody else is on the road",
    ),
}


@pytest.mark.parametrize(
    ("text", "target", "code", "reason"), IMPOSSIBLE.values(), ids=IMPOSSIBLE.keys()
)
def test_impossible_demands_are_refused_with_the_reason(
    scegen, tmp_path, text, target, code, reason
):
    done = scegen("generate", text, "-o", "out", "--target", target, "--check", "none")
    assert done.returncode == code, done.stderr
    assert reason in " ".join(done.stderr.split())
    assert (tmp_path / "out").exists() == (code == 1)


def test_what_does_not_hold_is_told_once(scegen):
    text = "A deer runs onto the road from the right, 30 m ahead of the ego, which drives 90 km/h."
    done = scegen("generate", text, "-o", "out", "--target", "near-miss")
    told = [line for line in (done.stdout + done.stderr).splitlines() if "touches anybody" in line]
    assert done.returncode == 1
    assert len([line for line in told if not line.startswith("skipped")]) == 1


def test_a_lone_ego_needs_no_danger(scegen, tmp_path):
    text = "The ego drives alone at a four-way intersection."
    done = scegen("generate", text, "-o", "out", "--check", "none")
    assert done.returncode == 0, done.stderr
    assert "avoided: nobody else is on the road" in " ".join(done.stderr.split())
    assert "skipped" not in done.stderr
    assert "a careful driver: " not in (tmp_path / "out" / "report.html").read_text("utf-8")


def test_a_selection_is_no_list_of_all(scegen):
    text = "Two cars and a truck meet at a four-way junction with signals while a child crosses."
    done = scegen("generate", text, "-o", "out", "--check", "none", "--target", "none")
    assert "3,456 distinct scenarios" in done.stderr
    assert "made 1 of 2,000 listed; more with --count or --pick" in done.stderr


def test_numbers_given_are_searched_only_on_request(scegen, tmp_path):
    text = "The ego turns left at a four-way intersection while an oncoming car goes straight."
    assert scegen("generate", text, "-o", "a", "--target", "none").returncode == 0
    (source,) = (tmp_path / "a").glob("scenarios/*/concrete.yaml")
    assert scegen("generate", source, "-o", "b").returncode == 0
    (kept,) = (tmp_path / "b").glob("scenarios/*/concrete.yaml")
    assert kept.read_bytes() == source.read_bytes()
    assert not (kept.parent / "proof.json").exists()
    assert scegen("generate", source, "-o", "c", "--target", "near-miss").returncode == 0
    (proof,) = (tmp_path / "c").glob("scenarios/*/proof.json")
    data = json.loads(proof.read_text())
    assert data["in_band"]
    assert data["changed"]


def test_a_minus_stands_for_what_comes_on_standard_input(scegen, tmp_path):
    told = b"\xef\xbb\xbfA van turns left at a crossroads.\r\n"
    said = scegen("understand", "A van turns left at a crossroads.").stdout
    assert scegen("understand", "-", stdin=told).stdout == said
    counted = scegen("enumerate", "-", "--count-only", stdin=said.encode())
    bare = tmp_path / "of_any_name"
    bare.write_text(said)
    for same in (bare, said):
        assert scegen("enumerate", same, "--count-only").stdout == counted.stdout
    assert counted.stdout == scegen("enumerate", "-", "--count-only", stdin=told).stdout
    logical = tmp_path / "logical.json"
    assert scegen("enumerate", "-", "-o", logical, stdin=told).returncode == 0
    quick = ("--check", "none", "--target", "none", "-o", "out")
    assert scegen("generate", "-", *quick, stdin=logical.read_bytes()).returncode == 0
    refused = scegen("understand", "-", "--report", stdin=b"Whisk three eggs.")
    assert refused.stdout.startswith("Whisk three eggs.\nnot about traffic")


def test_results_are_utf8_in_every_locale(scegen):
    plain = {"LC_ALL": "C", "PYTHONUTF8": "0", "PYTHONCOERCECLOCALE": "0"}
    told = "A van turns left at a crossroads in Zürich.".encode()
    done = scegen("understand", "-", process=True, stdin=told, **plain)
    assert done.returncode == 0, done.stderr
    assert "Zürich" in done.stdout
