"""The command line with language models: files, words, exit codes, and no key anywhere."""

import json
import os
from pathlib import Path

import pytest
from command import PROGRAM, as_process, in_process

KEY = "sk-secret-0123456789"
NO_SOCKETS = """
import socket
def refuse(*_):
    raise AssertionError("a replay opened a connection")
socket.socket.connect = socket.socket.connect_ex = socket.getaddrinfo = refuse
"""
FILES = ("functional.yaml", "logical.json", "report.html", "summary.json")


@pytest.fixture
def scegen(chat_server, tmp_path, capfd):
    def run(*arguments, code="", **environment):
        clean = {k: v for k, v in os.environ.items() if not k.lower().endswith("_proxy")}
        clean |= {"OPENAI_API_KEY": KEY, **environment}
        if code:
            done = as_process(arguments, tmp_path, clean, f"{code}\n{PROGRAM}")
        else:
            done = in_process(arguments, tmp_path, clean, capfd)
        assert "Traceback" not in done.stderr, done.stderr
        assert KEY not in done.stdout + done.stderr
        return done

    return run


def llm(chat_server):
    return ("--llm", "openai:scripted", "--llm-url", chat_server.url)


NUMBERS = {
    "changes": [
        {"parameter": "car_3.speed_mps", "value": 500, "reason": "quick <b>as</b> lightning"},
        {"parameter": "car_2.warp", "value": 9, "reason": "there is such a drive"},
    ]
}


@pytest.fixture
def all_answers(good_answers):
    """Answers for both stages."""
    return {**good_answers, "parameters": NUMBERS}


def generate(scegen, story, out, *options, **more):
    return scegen("generate", story, "-o", out, "--check", "none", *options, **more)


def test_generate_says_who_spoke(scegen, chat_server, all_answers, story, tmp_path):
    chat_server.answers = all_answers
    done = generate(scegen, story, "out", *llm(chat_server))
    assert done.returncode == 0, done.stderr
    assert "understood by openai:scripted" in done.stderr
    assert "numbers proposed by openai:scripted: 0 taken, 1 replaced, 1 dropped" in done.stderr
    summary = json.loads((tmp_path / "out" / "summary.json").read_text())
    assert summary["llm"]["speaker"] == "openai:scripted"
    # five agents, and twice the sixth, to whom somebody objected
    assert [len(chat_server.asked(a)) for a in ("road", "parameters")] == [1, 2]
    assert summary["llm"]["requests"] == 7
    assert (summary["llm"]["input_tokens"], summary["llm"]["output_tokens"]) == (700, 140)
    (scenario,) = summary["scenarios"]
    proposals = scenario["danger"]["proposals"]
    assert (proposals["by"], proposals["replaced"]) == ("openai:scripted", 1)
    report = (tmp_path / "out" / "report.html").read_text()
    assert "Who understood it" in report
    assert "Numbers proposed by openai:scripted" in report
    assert "quick &lt;b&gt;as&lt;/b&gt; lightning" in report
    assert "500: lies outside" in report
    assert "9: there is no such parameter" in report
    concrete = next((tmp_path / "out" / "scenarios").glob("*/concrete.yaml"))
    assert scegen("generate", str(concrete), "-o", "again", "--check", "none").returncode == 0


def test_one_budget_bounds_both_stages(scegen, chat_server, all_answers, story, tmp_path):
    chat_server.answers = all_answers
    limit = ("--llm-budget", "20k")
    done = generate(scegen, story, "out", *llm(chat_server), *limit)
    assert done.returncode == 0, done.stderr
    summary = json.loads((tmp_path / "out" / "summary.json").read_text())
    assert summary["llm"]["speaker"] == "openai:scripted"
    assert summary["scenarios"][0]["danger"]["proposals"]["by"] == "openai:scripted"
    held = generate(scegen, story, "more", *llm(chat_server), *limit, "--count", "9")
    assert held.returncode in {0, 1}, held.stderr  # one of nine may miss what is said
    summary = json.loads((tmp_path / "more" / "summary.json").read_text())
    assert summary["llm"]["input_tokens"] + summary["llm"]["output_tokens"] <= 19_000


def test_without_a_model_nothing_is_said_of_one(scegen, story, tmp_path):
    assert generate(scegen, story, "out").returncode == 0
    assert "llm" not in json.loads((tmp_path / "out" / "summary.json").read_text())
    assert "Who understood it" not in (tmp_path / "out" / "report.html").read_text()


def test_a_replay_writes_the_same_files(scegen, chat_server, all_answers, story, tmp_path):
    all_answers["road"] = {"junction": {"kind": "four_way", "arms": 4}}  # a disagreement
    chat_server.answers = all_answers
    options = ("--count", "2")
    first = generate(scegen, story, "one", *llm(chat_server), "--llm-record", "talk", *options)
    assert first.returncode == 0, first.stderr
    assert len(chat_server.asked("parameters")) == 4  # both scenarios, each objected to
    chat_server.stop()
    blocked = {"OPENAI_API_KEY": "", "code": NO_SOCKETS}
    again = generate(scegen, story, "two", "--llm-replay", "talk", *options, **blocked)
    assert again.returncode == 0, again.stderr
    one, two = (
        {p.relative_to(folder): p.read_bytes() for p in folder.rglob("*") if p.is_file()}
        for folder in (tmp_path / "one", tmp_path / "two")
    )
    assert {Path(name) for name in FILES} < one.keys()
    assert one == two
    report = (tmp_path / "one" / "report.html").read_text()
    assert "Read in two ways" in report
    assert all(KEY not in p.read_text("latin-1") for p in tmp_path.rglob("*") if p.is_file())
    other = generate(scegen, story, "three", "--llm-replay", "talk", *options, "--seed", "1")
    assert other.returncode == 2
    assert "answers another question: other options" in other.stderr


def test_a_failing_model_is_said_loudly(scegen, chat_server, story, tmp_path):
    chat_server.answers = {"*": chat_server.kinds["Status"](401, f"no such key {KEY}")}
    done = generate(scegen, story, "out", *llm(chat_server))
    assert done.returncode == 0, done.stderr
    assert "warning" in done.stderr
    assert "the offline reader understood the text" in done.stderr
    summary = json.loads((tmp_path / "out" / "summary.json").read_text())
    assert summary["llm"]["speaker"] == "offline reader"
    assert summary["llm"]["faults"][0]["kind"] == "authentication"
    (note,) = summary["scenarios"][0]["danger"]["proposals"]["notes"]
    assert "not asked again: answered with HTTP status 401" in note
    assert "numbers proposed by offline rules" in done.stderr
    assert "offline reader" in (tmp_path / "out" / "report.html").read_text()


def test_understand(scegen, chat_server, good_answers, story):
    chat_server.answers = good_answers
    done = scegen("understand", story, "--json", *llm(chat_server))
    assert done.returncode == 0, done.stderr
    assert json.loads(done.stdout)["junction"]["kind"] == "t"
    assert "understood by openai:scripted" in done.stderr


def test_any_compatible_endpoint(scegen, chat_server, good_answers, story):
    chat_server.answers = good_answers
    options = ("--llm", "my-model:8b", "--llm-url", chat_server.url)
    done = scegen("understand", story, *options, SCEGEN_LLM_KEY="another-secret-key")
    assert done.returncode == 0, done.stderr
    assert {body["model"] for _, body, _ in chat_server.requests} == {"my-model:8b"}
    keys = {headers["authorization"] for _, _, headers in chat_server.requests}
    assert keys == {"Bearer another-secret-key"}


def test_nothing_is_spent_on_a_folder_in_the_way(scegen, chat_server, story, tmp_path):
    (tmp_path / "out").mkdir()
    (tmp_path / "out" / "thesis.txt").write_text("years of work")
    done = generate(scegen, story, "out", *llm(chat_server))
    assert done.returncode == 2
    assert chat_server.requests == []


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (("--llm", "gpt-4o"), "known provider"),
        (("--llm", "deepseek:deepseek-chat"), "DEEPSEEK_API_KEY"),
        (("--llm-url", "http://127.0.0.1:9/v1"), "--llm-url: needs --llm"),
        (("--llm-budget", "5"), "--llm-budget: needs --llm"),
        (("--llm-record", "talk"), "--llm-record: needs --llm"),
        (("--llm", "openai:x", "--llm-budget", "much"), "--llm-budget"),
        (("--llm", "openai:x", "--llm-url", "nowhere"), "--llm-url"),
        (("--llm", "openai:x", "--llm-url", f"http://a:{KEY}@x/v1"), "SCEGEN_LLM_KEY"),
        (("--llm", "openai:x", "--llm-url", f"http://x/v1?key={KEY}"), "SCEGEN_LLM_KEY"),
        (("--llm-replay", "nowhere"), "run.json"),
        (("--llm-replay", "talk", "--llm-budget", "5"), "has no meaning"),
        (("--llm-replay", "talk", "--llm-timeout", "5"), "has no meaning"),
        (("--llm-timeout", "5"), "--llm-timeout: needs --llm"),
    ],
)
def test_options_that_make_no_sense(scegen, story, options, words):
    done = scegen("understand", story, *options, DEEPSEEK_API_KEY="")
    assert done.returncode == 2, done.stderr
    assert done.stdout == ""
    assert words in done.stderr


def test_a_missing_extra(scegen, story):
    blocked = (
        "import importlib.util as u; found = u.find_spec\n"
        "u.find_spec = lambda n, *a: None if n == 'pydantic_ai' else found(n, *a)\n"
        "import sys; sys.modules['pydantic_ai'] = None"
    )
    done = scegen("understand", story, "--llm", "openai:x", code=blocked)
    assert done.returncode == 3
    assert "pip install 'ml-scegen[llm]'" in done.stderr
    # everything else works without it
    assert scegen("understand", story, code=blocked).returncode == 0


@pytest.fixture
def labelled(story, tmp_path):
    expect = {
        "junction": ["t"],
        "hazards": {"must": ["speeding"], "may": ["unprotected_left_turn"]},
    }
    lines = [{"id": f"story {k}", "text": story, "expect": expect} for k in range(3)]
    (tmp_path / "cases.jsonl").write_text("\n".join(map(json.dumps, lines)))
    return "cases.jsonl"


def benchmark(scegen, labelled, *options, **more):
    return scegen("benchmark", "understand", labelled, *options, **more)


def test_benchmark_of_a_model(scegen, chat_server, good_answers, labelled):
    chat_server.answers = good_answers
    options = ("--repeat", "2", "--llm-timeout", "30", "--llm-budget", "400k")
    done = benchmark(scegen, labelled, *llm(chat_server), *options)
    assert done.returncode == 0, done.stderr
    for words in (
        "understood  6/6",
        "spoke         openai:scripted: 6 times",
        "latency       median",
        "30 requests, 3000 tokens in, 600 out, cost not known",
        "per reading   600 tokens",
        "stability over 2 runs",
    ):
        assert words in done.stdout
    assert "2/3 story 1, run 2: understood" in done.stderr


def test_benchmark_of_a_model_that_breaks(scegen, chat_server, good_answers, labelled):
    good = good_answers["road"]
    good_answers["road"] = [good, chat_server.kinds["Status"](401, f"no such key {KEY}")]
    chat_server.answers = good_answers
    done = benchmark(scegen, labelled, *llm(chat_server), "--repeat", "2", "--json")
    assert done.returncode == 1
    data = json.loads(done.stdout)
    assert (data["cases"], data["readings"], data["left"]) == (2, 4, 1)
    assert data["llm"]["speakers"]["openai:scripted"] == {"readings": 1, "understood": 1}
    assert "no such key [key]" in data["stopped"]
    assert "stopped: no model answered" in done.stderr


def test_benchmark_again_from_its_transcripts(
    scegen, chat_server, good_answers, labelled, tmp_path
):
    chat_server.answers = good_answers
    options = ("--llm", "my-model", "--llm-url", chat_server.url, "--llm-record", "talk")
    first = benchmark(scegen, labelled, *options, "--json", SCEGEN_LLM_KEY="another-secret-key")
    assert first.returncode == 0, first.stderr
    chat_server.stop()
    again = benchmark(scegen, labelled, "--llm-replay", "talk", "--json", code=NO_SOCKETS)
    assert again.stdout == first.stdout
    written = "".join(p.read_text() for p in tmp_path.rglob("*.json"))
    assert "my-model" in written
    assert "another-secret-key" not in written + first.stdout + first.stderr


JUDGE = """
def judge(facts, path):
    rows = open(path).read().splitlines()
    top = next(row for row in rows if row.startswith("Index"))
    count = sum("Entity_Name" in cell for cell in top.split(","))
    return [("cars", facts["cars"], count, count == facts["cars"])]
"""


def test_what_a_model_reads_is_played_and_judged(
    scegen, chat_server, good_answers, story, tmp_path
):
    lines = [
        {"id": f"story {k}", "text": story, "facts": {"cars": cars}} for k, cars in ((0, 4), (1, 9))
    ]
    (tmp_path / "told.jsonl").write_text("\n".join(map(json.dumps, lines)))
    (tmp_path / "judge.py").write_text(JUDGE)
    said = ("benchmark", "said", "told.jsonl", "--judge", "judge.py")
    chat_server.answers = good_answers
    done = scegen(*said, *llm(chat_server), "--llm-record", "talk")
    assert done.returncode == 1, done.stderr
    for words in (
        "cars                           1 of 2",
        "spoke         openai:scripted: 2 times, 1/2 (50.0 %) understood",
        "10 requests",
        "every fact right: 1 of 2 sentences",
    ):
        assert words in done.stdout
    chat_server.answers = good_answers | {
        "road": [chat_server.kinds["Status"](401, f"no such key {KEY}")] * 4
    }
    stopped = scegen(*said, "--only", "story 0", *llm(chat_server), "--json")
    data = json.loads(stopped.stdout)
    assert data["right"] == 1  # the offline reader spoke
    assert data["llm"]["faults"]
    other = [line | {"text": "A car brakes in front of the ego."} for line in lines]
    (tmp_path / "told.jsonl").write_text("\n".join(map(json.dumps, other)))
    refused = scegen(*said, "--llm-replay", "talk")
    assert refused.returncode == 2, refused.stderr
    assert "--llm-replay" in refused.stderr


def test_doctor_tests_a_connection(scegen, chat_server):
    chat_server.answers = {"probe": {"arms": 4}}
    done = scegen("doctor", *llm(chat_server))
    assert done.returncode == 0, done.stderr
    assert "serves   openai:scripted" in done.stdout
    chat_server.answers = {"probe": chat_server.kinds["Status"](401, f"wrong key {KEY}")}
    done = scegen("doctor", *llm(chat_server), "--json")
    assert done.returncode == 1
    (probe,) = json.loads(done.stdout)
    assert probe["fault"]["kind"] == "authentication"
    assert not probe["serves"]


def test_doctor_tests_every_model_of_a_chain(scegen, chat_server):
    chat_server.answers = {"probe": [chat_server.kinds["Status"](404), {"arms": 4}]}
    options = ("--llm", "openai:gone,openai:there", "--llm-url", chat_server.url)
    done = scegen("doctor", *options, "--llm-timeout", "20")
    assert done.returncode == 1
    assert "no use   openai:gone" in done.stdout
    assert "serves   openai:there" in done.stdout


def test_doctor_without_a_key_says_which(scegen):
    done = scegen("doctor", "--llm", "deepseek:deepseek-chat", DEEPSEEK_API_KEY="")
    assert done.returncode == 2
    assert "DEEPSEEK_API_KEY" in done.stderr


def test_an_address_in_the_environment_is_not_shown_with_its_key(scegen):
    address = f"http://user:{KEY}@127.0.0.1:9/v1"
    done = scegen("doctor", "--llm", "openai:x", OPENAI_BASE_URL=address)
    assert done.returncode == 2  # the fixture looks for the key everywhere
    assert "OPENAI_BASE_URL" in done.stderr


def test_the_libraries_own_logs_do_not_hold_the_key(scegen, chat_server, good_answers, story):
    chat_server.answers = good_answers
    loud = {"OPENAI_LOG": "debug", "code": "import logging; logging.basicConfig(level=1)"}
    done = scegen("understand", story, *llm(chat_server), **loud)
    assert done.returncode == 0, done.stderr
    assert "chat/completions" in done.stderr  # they did speak


def test_a_scenario_file_needs_no_model_to_be_understood(
    scegen, chat_server, all_answers, story, tmp_path
):
    (tmp_path / "in.yaml").write_text(scegen("understand", story).stdout)
    chat_server.answers = all_answers
    done = generate(scegen, "in.yaml", "out", *llm(chat_server))
    assert done.returncode == 0, done.stderr
    assert "no language model was asked to understand it" in done.stderr
    assert {agent for agent, _, _ in chat_server.requests} == {"parameters"}
    summary = json.loads((tmp_path / "out" / "summary.json").read_text())
    assert summary["llm"]["requests"] == len(chat_server.requests)
    assert "speaker" not in summary["llm"]
    assert "Who understood it" not in (tmp_path / "out" / "report.html").read_text()


def test_without_a_search_no_numbers_are_asked_for(scegen, chat_server, all_answers, story):
    chat_server.answers = all_answers
    done = generate(scegen, story, "out", *llm(chat_server), "--target", "none")
    assert done.returncode == 0, done.stderr
    assert chat_server.asked("parameters") == []
