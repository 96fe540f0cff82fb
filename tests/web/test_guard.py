"""Hosts, origins, tokens and sizes, before anything else is asked."""

import pytest

pytest.importorskip("nicegui", reason="the page needs the extra web")
from starlette.applications import Starlette
from starlette.responses import PlainTextResponse
from starlette.routing import Route, WebSocketRoute
from starlette.testclient import TestClient
from starlette.websockets import WebSocketDisconnect

from scegen.web.guard import LARGEST_BODY, Guard

HERE, THERE = "http://localhost:8750", "http://elsewhere.example"
TOKEN = "a-token-that-nobody-guesses"  # noqa: S105 - of this test


async def shown(request):
    body = await request.body()
    return PlainTextResponse(f"{len(body)} {request.headers.get('x-forwarded-prefix', '-')}")


async def talk(socket):
    await socket.accept()
    await socket.send_text("hello")
    await socket.close()


APP = Starlette(
    routes=[Route("/", shown, methods=["GET", "POST"]), WebSocketRoute("/ws", talk)],
)


def client(token=None, base=HERE):
    return TestClient(Guard(APP, token), base_url=base, follow_redirects=False)


def test_the_loopback_is_let_in_and_what_the_browser_may_do_is_bounded():
    answer = client().get("/", headers={"x-forwarded-prefix": '"><script>'})
    assert answer.text == "0 -"
    assert "frame-ancestors 'none'" in answer.headers["content-security-policy"]
    assert answer.headers["x-content-type-options"] == "nosniff"


@pytest.mark.parametrize(
    "host", ["elsewhere.example", "127.0.0.1.elsewhere.example", "", "10.0.0.1"]
)
def test_other_names_for_this_machine_are_refused(host):
    assert client().get("/", headers={"host": host}).status_code == 403


@pytest.mark.parametrize("origin", [THERE, "null", "http://localhost:8751", "file://"])
def test_requests_from_other_sites_are_refused(origin):
    assert client().post("/", headers={"origin": origin}).status_code == 403
    headers = {"origin": origin, "host": "localhost:8750"}
    with pytest.raises(WebSocketDisconnect) as refused:
        client().websocket_connect("/ws", headers=headers).__enter__()
    assert refused.value.code == 1008


def test_the_own_page_may_open_its_websocket():
    headers = {"origin": HERE, "host": "localhost:8750"}
    with client().websocket_connect("/ws", headers=headers) as socket:
        assert socket.receive_text() == "hello"


def test_a_body_that_is_too_large_is_refused_with_a_reason():
    answer = client().post("/", content=b"x" * (LARGEST_BODY + 1))
    assert answer.status_code == 413
    assert "too large" in answer.text


def test_others_need_the_token_once():
    visitor = client(TOKEN, base="http://192.0.2.1:8750")
    refused = visitor.get("/")
    assert refused.status_code == 401
    assert TOKEN not in refused.text
    assert visitor.get("/?token=wrong").status_code == 401
    let_in = visitor.get(f"/?token={TOKEN}")
    assert let_in.status_code == 303
    assert let_in.headers["location"] == "/"
    assert TOKEN not in let_in.headers["set-cookie"]
    assert visitor.get("/").status_code == 200


def test_a_websocket_needs_the_token_too():
    visitor = client(TOKEN)
    with pytest.raises(WebSocketDisconnect):
        visitor.websocket_connect("/ws", headers={"host": "localhost:8750"}).__enter__()
