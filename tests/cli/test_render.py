"""scegen render: what it makes, where, and what it says when it cannot."""

import importlib.util
from io import BytesIO

import pytest
from PIL import Image

SENTENCE = "The ego follows a car on a straight road. The car brakes hard."
needs_ffmpeg = pytest.mark.skipif(
    importlib.util.find_spec("imageio_ffmpeg") is None, reason="needs ml-scegen[video]"
)


@pytest.fixture
def made(scegen, tmp_path):
    done = scegen("generate", SENTENCE, "-o", "made", "--check", "none")
    assert done.returncode == 0
    return tmp_path / "made"


def test_a_gif_lies_in_the_scenario_and_is_ours(scegen, made):
    short = ("--from", "1", "--to", "1.5", "--width", "240")
    done = scegen("render", "made", *short)
    (file,) = made.glob("scenarios/*/animation.gif")
    assert done.stdout == f"{file.relative_to(made.parent)}\n"
    content = file.read_bytes()
    with Image.open(BytesIO(content)) as film:
        assert film.format == "GIF"
        assert film.width == 240
        assert film.n_frames == 6
        assert film.info["loop"] == 0
    assert scegen("render", "made", "-o", "again.gif", *short).returncode == 0
    assert (made.parent / "again.gif").read_bytes() == content
    again = scegen("generate", SENTENCE, "-o", "made", "--check", "none")
    assert again.returncode == 0, again.stderr
    assert not file.exists()


def test_a_still_shows_the_moment_asked_for(scegen, made):
    for name, options in (("a", ("--at", "0.5")), ("b", ()), ("c", ("--theme", "dark"))):
        assert scegen("render", "made", "--png", "-o", f"{name}.png", *options).returncode == 0
    pictures = [(made.parent / f"{name}.png").read_bytes() for name in "abc"]
    assert len(set(pictures)) == 3
    with Image.open(BytesIO(pictures[0])) as still:
        assert still.width == 720


@needs_ffmpeg
def test_a_video_is_the_same_every_time(scegen, made):
    for name in ("a.mp4", "b.mp4"):
        done = scegen("render", "made", "-o", name, "--from", "1", "--to", "1.4", "--width", "240")
        assert done.returncode == 0, done.stderr
    first, second = ((made.parent / name).read_bytes() for name in ("a.mp4", "b.mp4"))
    assert first == second
    assert first[4:8] == b"ftyp"


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (("--gif", "--png"), "at a time"),
        (("-o", "film.avi"), "no .gif, .mp4 or .png"),
        (("--png", "-o", "film.gif"), "no .png"),
        (("--from", "3", "--to", "2"), "not after --from"),
        (("--to", "0"), "not after --from 0 s"),
        (("--from", "500"), "lies beyond the end"),
        (("--png", "--at", "500"), "lies beyond the end"),
        (("--at", "3"), "is the moment of a .png"),
        (("--scenario", "nobody"), "there is no scenario"),
    ],
)
def test_what_cannot_be_made_is_said(scegen, made, options, words):
    done = scegen("render", "made", *options)
    assert done.returncode == 2
    assert words in done.stderr
