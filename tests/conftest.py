"""A server on 127.0.0.1 that speaks the OpenAI chat protocol with scripted answers and faults."""

from __future__ import annotations

import json
import socket
import struct
import threading
import time
from dataclasses import dataclass, field
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer

import pytest
from browsing import HINT, a_browser, chromium
from hypothesis import HealthCheck, settings

from scegen.llm import LlmSettings, parse_models
from scegen.llm.settings import Limits

# A machine under load is no reason to fail: nothing is told by how long it took.
settings.register_profile("anywhere", deadline=None, suppress_health_check=[HealthCheck.too_slow])
settings.load_profile("anywhere")

KEY = "sk-secret-0123456789"
PATIENT = Limits(
    request_s=60, run_s=300, attempts=3, first_wait_s=0.01, longest_wait_s=0.2, answer_bytes=50_000
)
"""Nothing runs out of time, however slow the machine; a server that never ends needs less."""
PARTS = {
    "the road": "road",
    "the participants": "participants",
    "the dangers": "hazards",
    "what happens": "acts",
    "the review": "reviewer",
    "the numbers": "parameters",
}


@dataclass(frozen=True)
class Status:
    """An HTTP error."""

    code: int
    message: str = "no"
    headers: tuple[tuple[str, str], ...] = ()


@dataclass(frozen=True)
class Raw:
    """A body that is sent as it is."""

    body: bytes
    content_type: str = "application/json"
    headers: tuple[tuple[str, str], ...] = ()


@dataclass(frozen=True)
class Arguments:
    """A tool call with these very characters as its arguments."""

    text: str


@dataclass(frozen=True)
class Text:
    """A message in prose."""

    content: str | None
    finish: str = "stop"


@dataclass(frozen=True)
class Refusal:
    """A refusal in the protocol's own field."""

    words: str


@dataclass(frozen=True)
class Drip:
    """A byte now and then, until the client has had enough."""


class Reset:
    """The connection is reset in the middle of the answer."""


@dataclass
class Script:
    """The server's answers by agent, in order; the last one is repeated."""

    answers: dict = field(default_factory=dict)
    requests: list = field(default_factory=list)
    meeting: threading.Barrier | None = None
    url: str = ""
    lock: threading.Lock = field(default_factory=threading.Lock)

    def asked(self, agent):
        """Bodies of the requests of one agent."""
        return [body for name, body, _ in self.requests if name == agent]

    @property
    def together(self):
        """So many requests are answered only when all of them are there."""
        return 0 if self.meeting is None else self.meeting.parties

    def next(self, agent):
        """The answer to the next request of an agent."""
        answers = self.answers[agent] if agent in self.answers else self.answers["*"]
        if not isinstance(answers, list):
            return answers
        return answers.pop(0) if len(answers) > 1 else answers[0]


def agent_of(body):
    said = [m["content"] for m in body["messages"] if m["role"] in {"system", "developer"}]
    system = str(said or body.get("system"))  # Anthropic's protocol has it beside the messages
    for words, name in PARTS.items():
        if f"Your part of the work: {words}." in system:
            return name
    return "probe"


def completion(message, finish="stop"):
    return json.dumps(
        {
            "id": "chat-1",
            "object": "chat.completion",
            "created": 1700000000,
            "model": "scripted",
            "choices": [{"index": 0, "finish_reason": finish, "message": message}],
            "usage": {"prompt_tokens": 100, "completion_tokens": 20, "total_tokens": 120},
        }
    ).encode()


class Handler(BaseHTTPRequestHandler):
    protocol_version = "HTTP/1.1"
    script: Script

    def log_message(self, *_):
        pass

    def do_POST(self):
        body = json.loads(self.rfile.read(int(self.headers["Content-Length"])))
        agent = agent_of(body)
        script = self.script
        with script.lock:
            headers = {name.lower(): value for name, value in self.headers.items()}
            script.requests.append((agent, body, headers))
            meeting = script.meeting if len(script.requests) <= script.together else None
            answer = script.next(agent)
        if meeting is not None:
            meeting.wait()
        try:
            self.answer(answer)
        except OSError:  # the client gave up, as it should on a drip
            self.close_connection = True

    def answer(self, answer):
        match answer:
            case Status():
                content = json.dumps({"error": {"message": answer.message}}).encode()
                self.send(content, status=answer.code, headers=answer.headers)
            case Raw():
                self.send(answer.body, content_type=answer.content_type, headers=answer.headers)
            case Text():
                message = {"role": "assistant", "content": answer.content}
                self.send(completion(message, answer.finish))
            case Refusal():
                message = {"role": "assistant", "content": None, "refusal": answer.words}
                self.send(completion(message))
            case Drip():
                self.drip()
            case Reset():
                self.reset()
            case Arguments():
                self.call(answer.text)
            case _:
                self.call(json.dumps(answer))

    def call(self, arguments):
        function = {"name": "answer", "arguments": arguments}
        call = {"id": "call_1", "type": "function", "function": function}
        message = {"role": "assistant", "content": None, "tool_calls": [call]}
        self.send(completion(message, "tool_calls"))

    def send(self, content, *, status=200, headers=(), content_type="application/json"):
        self.send_response(status)
        self.send_header("Content-Type", content_type)
        self.send_header("Content-Length", str(len(content)))
        for name, value in headers:
            self.send_header(name, value)
        self.end_headers()
        self.wfile.write(content)

    def drip(self):
        self.send_response(200)
        self.send_header("Content-Type", "application/json")
        self.send_header("Content-Length", "1000000")
        self.end_headers()
        while True:
            self.wfile.write(b" ")
            self.wfile.flush()
            time.sleep(0.02)

    def reset(self):
        self.send_response(200)
        self.send_header("Content-Length", "1000")
        self.end_headers()
        self.wfile.write(b"{")
        self.wfile.flush()
        # lingering for 0 s makes close() send RST instead of FIN
        linger = struct.pack("ii", 1, 0)
        self.connection.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, linger)
        self.close_connection = True


@pytest.fixture(scope="session")
def browser():
    """One for all: two of them in a process get in each other's way."""
    if chromium() is None:
        pytest.skip(HINT)
    with a_browser() as found:
        yield found


@pytest.fixture
def chat_server(monkeypatch):
    """A scripted model; everything else is out of reach."""
    for name in ("HTTP_PROXY", "HTTPS_PROXY", "ALL_PROXY"):
        monkeypatch.delenv(name, raising=False)
        monkeypatch.delenv(name.lower(), raising=False)
    script = Script()
    handler = type("ScriptedHandler", (Handler,), {"script": script})
    server = ThreadingHTTPServer(("127.0.0.1", 0), handler)
    server.daemon_threads = True
    script.url = f"http://127.0.0.1:{server.server_address[1]}/v1"
    script.kinds = {
        kind.__name__: kind for kind in (Status, Raw, Arguments, Text, Refusal, Drip, Reset)
    }
    thread = threading.Thread(target=server.serve_forever, kwargs={"poll_interval": 0.01})
    thread.start()
    script.stop = server.shutdown
    yield script
    server.shutdown()
    server.server_close()
    thread.join()


@pytest.fixture
def environment():
    return {"OPENAI_API_KEY": KEY, "DEEPSEEK_API_KEY": KEY}


@pytest.fixture
def settings_for(chat_server):
    """Settings for the scripted model, without waits between attempts."""

    def make(models="openai:scripted", **changes):
        url = changes.pop("url", chat_server.url)
        changes.setdefault("limits", PATIENT)
        return LlmSettings(models=parse_models(models, url=url), url=url, **changes)

    return make


STORY = (
    "Three cars meet at a T-intersection in the rain. One car speeds at 72 km/h while a lorry "
    "turns left in front of it."
)


def _car(name, **more):
    return {"id": name, "kind": "car", **more}


GOOD_ANSWERS = {
    "road": {
        "junction": {"kind": "t", "arms": 3},
        "environment": {"weather": "rain"},
        "basis": [
            {"field": "junction.kind", "words": "T-intersection"},
            {"field": "weather", "words": "in a thunderstorm"},
        ],
    },
    "participants": {
        "participants": [
            _car("car_1", speed_mps={"low": 20.0, "high": 20.0}),
            _car("car_2", role="ego"),
            _car("car_3"),
            {"id": "truck_1", "kind": "truck", "maneuvers": ["left"]},
        ],
        "basis": [
            {"field": "participants.car_1.kind", "words": "Three cars"},
            {"field": "participants.car_1.speed_mps", "words": "72 km/h"},
            {"field": "participants.truck_1.maneuvers", "words": "turns left"},
            {"field": "participants.car_2.role", "reason": "the first that causes no danger"},
        ],
        "unsupported": [{"words": "in front of it", "instead": "left to the choice of numbers"}],
    },
    "hazards": {
        "hazards": [
            {"kind": "speeding", "by": ["car_1"], "to": ["truck_1"]},
            {"kind": "unprotected_left_turn", "by": ["truck_1"], "to": ["car_1"]},
        ],
        "basis": [{"field": "speeding", "words": "speeds at  72 KM/H"}],
    },
    "acts": {},
    "reviewer": {"objections": []},
}


@pytest.fixture
def story():
    """A description, for which :func:`good_answers` are right."""
    return STORY


@pytest.fixture
def good_answers():
    """One good answer of every agent; two quotes are loose, one is invented."""
    return json.loads(json.dumps(GOOD_ANSWERS))
