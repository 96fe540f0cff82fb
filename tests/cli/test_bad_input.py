"""Bad input: one clear message, exit code 2, no traceback, nothing half-written."""

import pytest

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
        ("Preheat the oven and whisk three eggs with sugar.", "traffic"),
        ("40 cars enter a four-way intersection from the same arm.", "40"),
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
        (("--reduction", "total"), "--reduction"),
    ],
)
def test_options_out_of_range(scegen, tmp_path, options, words):
    done = scegen("generate", SENTENCE, "-o", tmp_path / "out", *options)
    assert done.returncode == 2
    assert words in done.stderr
    assert "Traceback" not in done.stderr
    assert not (tmp_path / "out").exists()


def test_maneuvers_that_no_arm_allows(scegen, tmp_path):
    (tmp_path / "in.yaml").write_text(
        "level: functional\ndescription: a fifth exit\njunction: {kind: roundabout, arms: 4}\n"
        "participants: [{id: ego, role: ego, maneuvers: [exit_5]}]\n"
    )
    assert_refused(scegen("generate", "in.yaml", "-o", "out"), "ego")


def test_checking_what_is_not_there(scegen, tmp_path):
    assert_refused(scegen("check", tmp_path / "nowhere"), "nowhere")
    assert_refused(scegen("check", tmp_path), str(tmp_path))
