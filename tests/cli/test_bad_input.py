"""Bad input: one clear message, exit code 2, no traceback, nothing half-written."""

import json
import math

import pytest
from whole import FUNCTIONAL, WHOLE

from scegen.pipeline.source import resolve_source

SENTENCE = "Two cars meet at a four-way intersection."


def assert_refused(done, words):
    assert done.returncode == 2, done.stderr
    assert done.stdout == ""
    assert "Traceback" not in done.stderr
    assert words in done.stderr
    assert len(done.stderr.strip().splitlines()) <= 4


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("", "empty"),
        ("   \n ", "empty"),
        ("A van turns left in Z\udcfcrich.", "broken characters"),
        ("Preheat the oven and whisk three eggs with sugar.", "traffic"),
        ("40 cars enter a four-way intersection.", "at most 24"),
        ("Two cars meet at a roundabout with 1 exit.", "1 exit"),
        ("Two cars meet at a roundabout with 12 exits.", "12 exits"),
        (
            "At a four-way intersection the ego turns left and the ego turns right "
            "while another car goes straight.",
            "left",
        ),
    ],
)
def test_texts_that_cannot_be_used(scegen, tmp_path, text, words):
    out = tmp_path / "out"
    assert_refused(scegen("generate", text, "-o", out), words)
    assert not out.exists()


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("Zwei Autos treffen sich an einer Kreuzung, und eines nimmt die Vorfahrt.", "German"),
        ("Le véhicule freine brusquement devant un piéton qui traverse la rue.", "French"),
        ("Un camión frena bruscamente delante del coche en la autopista.", "Spanish"),
        ("一辆汽车在十字路口左转，挡住了一名骑自行车的人。", "Latin letters"),
    ],
)
@pytest.mark.parametrize("command", ["generate", "understand", "enumerate"])
def test_texts_in_another_language(scegen, tmp_path, command, text, words):
    done = scegen(command, text, *READING[command])
    assert_refused(done, words)
    assert "only English is read" in done.stderr
    assert not list(tmp_path.iterdir())


def test_a_missing_file_is_named(scegen, tmp_path):
    assert_refused(scegen("generate", "nowhere.yaml", "-o", "out"), "nowhere.yaml: there is no")


def test_an_unreadable_file_is_named(scegen, tmp_path):
    (tmp_path / "text.txt").write_bytes(b"\xff\xfe\x00\x80")
    assert_refused(scegen("generate", "text.txt", "-o", "out"), "text.txt")


@pytest.mark.parametrize(
    ("content", "words"),
    [
        ("level: functional\n  junction: [", "not valid YAML"),
        (
            "level: functional\ndescription: x\njunction: {kind: hexagon, arms: 6}\n"
            "participants: [{id: ego, role: ego}]\n",
            "hexagon",
        ),
        (
            "level: functional\ndescription: x\njunction: {kind: t, arms: 3}\n"
            "participants: [{id: ego, role: ego, maneuvers: [fly]}]\n",
            "fly",
        ),
        ("level: sublime\n", "level"),
        ('{"level": "functional", "description": "\\ud800"}', "cannot be read"),
    ],
)
def test_broken_files_are_named(scegen, tmp_path, content, words):
    (tmp_path / "in.yaml").write_text(content)
    done = scegen("generate", "in.yaml", "-o", "out")
    assert_refused(done, words)
    assert "in.yaml" in done.stderr
    assert not (tmp_path / "out").exists()


def test_a_folder_that_cannot_be_written(scegen, tmp_path):
    (tmp_path / "file").write_text("in the way")
    assert_refused(
        scegen("generate", SENTENCE, "-o", tmp_path / "file" / "out"), "cannot be written"
    )


def test_a_folder_with_somebody_elses_files(scegen, tmp_path):
    (tmp_path / "thesis.txt").write_text("years of work")
    assert_refused(scegen("generate", SENTENCE, "-o", tmp_path), "--force")
    assert [p.name for p in tmp_path.iterdir()] == ["thesis.txt"]


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (("--pick", "99999"), "names no logical scenario"),
        (("--count", "0"), "--count"),
        (("--seed", "-1"), "--seed"),
        (("--reduction", "total"), "--reduction': 'total' is not one of"),
        (("--seed", "1.5"), "--seed': it must be a whole number"),
        (("--solutions", "0"), "--solutions': it must be at least 1"),
        (("--llm-timeout", "soon"), "--llm-timeout': it must be a number"),
        (("--rules", "nowhere.lp"), "nowhere.lp: cannot be read"),
    ],
)
def test_options_out_of_range(scegen, tmp_path, options, words):
    done = scegen("generate", SENTENCE, "-o", tmp_path / "out", *options)
    assert done.returncode == 2
    assert words in done.stderr
    assert "Traceback" not in done.stderr
    assert not (tmp_path / "out").exists()


def test_what_a_command_does_not_take(scegen, tmp_path):
    for level, data in WHOLE.items():
        (tmp_path / f"{level}.json").write_text(json.dumps(data))
    assert_refused(scegen("concretize", "functional.json", "--index", "0"), "scegen enumerate")
    assert_refused(scegen("concretize", "logical.json", "--index", "7"), "--index: '7' names no")
    assert_refused(scegen("trace", "functional.json"), "scegen concretize writes one")
    assert_refused(scegen("enumerate", "concrete.json"), "name the functional.yaml")
    assert_refused(scegen("generate", "concrete.json", "-o", "out", "--pick", "3"), "nothing to")
    assert_refused(scegen("play", "logical.json"), "or a scenario.xosc in it")


def test_maneuvers_that_no_arm_allows(scegen, tmp_path):
    (tmp_path / "in.yaml").write_text(
        "level: functional\ndescription: a fifth exit\njunction: {kind: roundabout, arms: 4}\n"
        "participants: [{id: ego, role: ego, maneuvers: [exit_5]}]\n"
    )
    assert_refused(scegen("generate", "in.yaml", "-o", "out"), "ego")


def test_checking_what_is_not_there(scegen, tmp_path):
    assert_refused(scegen("check", tmp_path / "nowhere"), "nowhere")
    assert_refused(scegen("check", tmp_path), str(tmp_path))


DEEP = 100_000
LAUGHS = "level: functional\na0: &a0 [x]\n" + "\n".join(
    f"a{n}: &a{n} [{', '.join([f'*a{n - 1}'] * 10)}]" for n in range(1, 10)
)
BROKEN = {
    "deep.json": ('{"a":' * DEEP, "nested too deeply"),
    "deep list.json": ("[" * DEEP, "nested too deeply"),
    "deep flow.yaml": ("a: " + "[" * DEEP + "]" * DEEP, "nested too deeply"),
    "deep block.yaml": ("- " * DEEP, "nested too deeply"),
    "laughs.yaml": (LAUGHS, "aliases repeat"),
    "circle.yaml": ("a: &a [*a]", "the alias *a stands in itself"),
    "empty.yaml": ("", "is empty"),
    "picture.json": (b"\x89PNG\r\n\x1a\n\0", "is not UTF-8 text"),
    "zeros.yaml": (b"\0\0\0", "is no text"),
    "tab.yaml": ("level: functional\njunction:\n\tkind: t\n", "indent with blanks"),
    "twice.yaml": ("level: functional\nlevel: logical\n", "'level' is given twice"),
    "twice.json": ('{"level": "functional", "level": "logical"}', "'level' is given twice"),
    "list.json": ("[1, 2]", "its level is nothing"),
    "level.json": ('{"level": ["functional"]}', "its level is a list"),
    "date.yaml": ("level: 2024-13-45", "a date or a number that does not exist"),
    "number.json": ('{"level": ' + "9" * 5000 + "}", "a date or a number that does not exist"),
    "comma.json": ('{"level": "functional",}', "not valid JSON at line 1"),
}
READING = {
    "generate": ("-o", "out"),
    "enumerate": (),
    "understand": (),
    "concretize": ("--index", "0"),
    "gallery": (),
    "trace": (),
}


@pytest.mark.parametrize("command", READING)
@pytest.mark.parametrize("name", BROKEN)
def test_whatever_a_file_holds(scegen, tmp_path, command, name):
    content, words = BROKEN[name]
    (tmp_path / name).write_bytes(content if isinstance(content, bytes) else content.encode())
    done = scegen(command, name, *READING[command])
    assert_refused(done, words)
    assert name in done.stderr
    assert [p.name for p in tmp_path.iterdir()] == [name]


@pytest.mark.parametrize("name", BROKEN)
def test_whatever_a_concrete_scenario_that_is_checked_holds(scegen, tmp_path, name):
    content, words = BROKEN[name]
    for file in ("road.xodr", "scenario.xosc"):
        (tmp_path / file).write_text("<x/>")
    content = content if isinstance(content, bytes) else content.encode()
    (tmp_path / "concrete.yaml").write_bytes(content)
    assert_refused(scegen("check", "."), words)


def test_a_deep_file_does_not_bring_the_process_down(scegen, tmp_path):
    """A stack that overflows outside Python ends the process itself."""
    (tmp_path / "deep.yaml").write_text("[" * DEEP)
    for command in ("enumerate", "generate", "check"):
        done = scegen(command, "deep.yaml", *READING.get(command, ()), process=True)
        assert_refused(done, "deep.yaml")


@pytest.mark.parametrize("command", READING)
def test_what_is_no_file_at_all(scegen, tmp_path, command):
    (tmp_path / "loop.yaml").symlink_to("loop.yaml")
    (tmp_path / "folder.yaml").mkdir()
    for name in ("loop.yaml", "folder.yaml", "nowhere.yaml"):
        assert_refused(scegen(command, name, *READING[command]), name)


@pytest.mark.parametrize("name", ["deep.json", "picture.json", "empty.yaml", "list.json"])
@pytest.mark.parametrize("kind", ["understand", "said"])
def test_labelled_files_too(scegen, tmp_path, name, kind):
    content, _ = BROKEN[name]
    (tmp_path / name).write_bytes(content if isinstance(content, bytes) else content.encode())
    assert_refused(scegen("benchmark", kind, name), name)


def test_a_number_stands_for_a_range_wherever_a_file_is_read(scegen, tmp_path):
    text = json.dumps(FUNCTIONAL | {"acts": [], "spacings": [], "relations": []})
    (tmp_path / "in.json").write_text(text.replace('{"low": 10.0, "high": 12.0}', "10.0"))
    for command in ("understand", "enumerate"):
        done = scegen(command, "in.json", "--json")
        assert done.returncode == 0, done.stderr
    ego = json.loads(scegen("understand", "in.json", "--json").stdout)["participants"][0]
    assert ego["speed_mps"] == {"low": 10.0, "high": 10.0}


@pytest.mark.parametrize(
    ("level", "field", "value", "words"),
    [
        ("functional", "junction", {"kind": "hexagon"}, "junction.kind: 'hexagon' is not one of"),
        ("functional", "particpants", [], "did you mean participants?"),
        ("logical", "reduction", "total", "reduction: 'total' is not one of the words allowed"),
        ("concrete", "duration_s", math.nan, "duration_s: nan is not a number that is finite"),
        ("concrete", "duration_s", 1e300, "duration_s: 1e+300 is not allowed: it must be at most"),
        ("concrete", "seed", "x", "seed: 'x' is not a whole number"),
    ],
)
def test_fields_are_complained_about_in_words(scegen, tmp_path, level, field, value, words):
    (tmp_path / "in.json").write_text(json.dumps(WHOLE[level] | {field: value}))
    assert_refused(scegen("generate", "in.json", "-o", "out"), words)


ONE = WHOLE["logical"]["scenarios"][0]
DRIVE, WALK, MET = ONE["assignments"][0], ONE["assignments"][2], ONE["conflicts"][0]


@pytest.mark.parametrize(
    ("scenarios", "words"),
    [
        ([], "holds no logical scenario"),
        ([ONE, ONE], "two scenarios have the index 0"),
        ([ONE | {"assignments": ONE["assignments"][1:]}], "participant 'ego' has no assignment"),
        (
            [ONE | {"assignments": [*ONE["assignments"], DRIVE]}],
            "participant 'ego' has 2 assignments",
        ),
        (
            [ONE | {"assignments": [*ONE["assignments"], DRIVE | {"participant": "ghost"}]}],
            "there is no participant 'ghost'; there are box, car_1, ego, van, walker",
        ),
        (
            [ONE | {"assignments": [DRIVE | {"exit": 4}, *ONE["assignments"][1:]]}],
            "ego uses arm 4, outside 0..3",
        ),
        (
            [ONE | {"assignments": [DRIVE | {"exit": 3}, *ONE["assignments"][1:]]}],
            "ego enters at arm 0 with move 2: its exit is 2",
        ),
        (
            [ONE | {"assignments": [DRIVE | {"turn": "left"}, *ONE["assignments"][1:]]}],
            "ego goes from arm 0 to 2: its turn is straight",
        ),
        (
            [ONE | {"assignments": [DRIVE | {"maneuver": "right"}, *ONE["assignments"][1:]]}],
            "ego turns straight: its maneuver is one of",
        ),
        (
            [ONE | {"assignments": [WALK | {"participant": "ego"}, *ONE["assignments"][1:]]}],
            "ego has the type crossing, and can only have drive",
        ),
        ([ONE | {"pattern": [1, 2]}], "the pattern of its moves is [2, 2]"),
        ([ONE | {"conflicts": [MET | {"second": "ego"}]}], "ego has a conflict with itself"),
        ([ONE | {"conflicts": [MET | {"yields": "walker"}]}], "walker yields in a conflict of"),
        ([ONE | {"parameters": 2 * ONE["parameters"]}], "'ego.speed_mps' is given 2 times"),
        ([ONE | {"hazards": [{"kind": "cut_in", "by": ["ghost"]}]}], "no participant 'ghost'"),
        ([ONE | {"deadlock": ["ghost"]}], "no participant 'ghost'"),
        (
            [ONE | {"parameters": [ONE["parameters"][0] | {"name": "ego.warp"}]}],
            "there is no parameter 'ego.warp'",
        ),
    ],
)
@pytest.mark.parametrize("command", ["generate", "concretize", "gallery"])
def test_logical_scenarios_that_cannot_be(scegen, tmp_path, command, scenarios, words):
    content = WHOLE["logical"] | {"scenarios": scenarios}
    (tmp_path / "in.json").write_text(json.dumps(content))
    assert_refused(scegen(command, "in.json", *READING[command]), words)


def test_a_certificate_in_a_file_is_not_believed(scegen, tmp_path):
    done = scegen("enumerate", "--entries", "0,1", "--junction-arms", "4", "-o", "in.json")
    assert done.returncode == 0, done.stderr
    listed = json.loads((tmp_path / "in.json").read_text())
    right = listed["certificate"]
    listed["certificate"] = right | {"count": 1, "total": 3, "complete": True}
    (tmp_path / "in.json").write_text(json.dumps(listed))
    plain = ("--check", "none", "--target", "none")
    assert scegen("generate", "in.json", "-o", "out", *plain).returncode == 0
    made = json.loads((tmp_path / "out" / "logical.json").read_text())
    assert {name: made["certificate"][name] for name in ("count", "total", "complete")} == {
        name: right[name] for name in ("count", "total", "complete")
    }
    assert "claims 1 scenario of 3 assignments" in made["notes"][-1]


def test_nor_are_class_sizes(scegen, tmp_path):
    done = scegen("enumerate", "--entries", "0,1", "--junction-arms", "4", "-o", "in.json")
    assert done.returncode == 0, done.stderr
    listed = json.loads((tmp_path / "in.json").read_text())
    listed["scenarios"][0]["class_size"] += 5
    (tmp_path / "in.json").write_text(json.dumps(listed))
    recounted = resolve_source(str(tmp_path / "in.json"))
    total = recounted.certificate.total
    assert not recounted.certificate.complete
    assert f"add up to {total + 5}; there are {total} assignments" in recounted.notes[-1]
