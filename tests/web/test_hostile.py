"""Hostile visitors: nothing is executed, nothing leaks, and each hears why."""

import http.client
import json
from urllib.parse import parse_qs, urlsplit

import pytest
from websockets.exceptions import InvalidStatus
from websockets.sync.client import connect

from scegen.web.guard import LARGEST_BODY

pytestmark = pytest.mark.browser
SCRIPT = '<script>document.title="owned"</script><img src=x onerror=alert(1)>'


def asked(server, method, path, headers=None, body=None):
    """(status, text) of a request of one's own making."""
    place = urlsplit(server.url)
    line = http.client.HTTPConnection(place.hostname, place.port, timeout=60)
    line.putrequest(method, path, skip_host="host" in (headers or {}), skip_accept_encoding=True)
    for name, value in (headers or {}).items():
        line.putheader(name, value)
    line.endheaders(body)
    answer = line.getresponse()
    return answer.status, answer.read().decode(errors="replace")


def test_markup_in_a_description_stays_text(server, visit):
    visitor = visit(server.url)
    visitor.understood(f"The ego {SCRIPT} turns left at a four-way intersection.")
    visitor.page.wait_for_selector(".description mark")
    visitor.go("Choose")
    visitor.page.wait_for_selector(".tile svg")
    assert visitor.page.title() == "ML-SceGen"
    assert visitor.page.locator("img").count() == 0
    own = urlsplit(server.url).netloc
    assert {urlsplit(url).netloc for url in visitor.requested} == {own}


@pytest.mark.parametrize(
    ("name", "content", "said"),
    [
        ("a.yaml", b"a: &a [x]\nb: &b [*a, *a]\nlevel: 1", "no scenario file"),
        ("a.zip", b"PK\x05\x06" + bytes(18), "holds none of"),
        (f"{SCRIPT[:30]}.png", b"x", "neither a scenario file"),
    ],
)
def test_hostile_files_are_refused_in_words(server, visit, name, content, said):
    visitor = visit(server.url)
    visitor.page.get_by_role("button", name="Open").click()
    visitor.page.wait_for_selector(".sheet")
    visitor.page.set_input_files(
        "input[type=file]", {"name": name, "mimeType": "text/plain", "buffer": content}
    )
    visitor.page.wait_for_selector(f".problem >> text={said}")


def test_rules_read_no_other_file(server, visit):
    visitor = visit(server.url)
    visitor.understood("Two cars meet at a four-way intersection.")
    visitor.go("Choose")
    visitor.page.get_by_text("Rules of your own").click()
    visitor.page.get_by_label("Rules in answer set programming").fill('#include "/etc/passwd".')
    visitor.page.get_by_role("button", name="Keep them").click()
    visitor.page.wait_for_selector(".tiles .problem >> text=#include is not read")
    assert "root:x" not in visitor.page.content()


@pytest.mark.parametrize(("of", "edition"), [("1", 0), ("1", 99), ("100000", None)])
def test_tiles_of_a_list_that_is_gone_are_none_and_no_error(server, visit, of, edition):
    visitor = visit(server.url)
    visitor.understood("Two cars meet at a four-way intersection.")
    visitor.go("Choose")
    visitor.page.wait_for_selector(".tile svg")
    present = next(url for url in visitor.requested if "/tiles?" in url)
    edition = parse_qs(urlsplit(present).query)["edition"][0] if edition is None else edition
    answer = visitor.context.request.get(f"{server.url}/tiles?of={of}&edition={edition}")
    assert (answer.status, answer.json()) == (200, [])
    assert visitor.context.request.get(present).json() != []


def test_ten_megabytes_are_not_even_sent(server, visit):
    visitor = visit(server.url)
    visitor.page.get_by_role("button", name="Open").click()
    visitor.page.wait_for_selector(".sheet")
    visitor.page.set_input_files(
        "input[type=file]",
        {"name": "big.yaml", "mimeType": "text/plain", "buffer": b"x" * 10_000_000},
    )
    visitor.page.wait_for_selector("text=at most 2 MB")


def test_ten_megabytes_sent_all_the_same_are_refused(server):
    status, text = asked(server, "POST", "/upload", {"content-length": str(10_000_000)})
    assert (status, "too large" in text) == (413, True)
    assert LARGEST_BODY < 10_000_000


@pytest.mark.parametrize(
    "path",
    [
        "/download/file?name=../../../etc/passwd",
        "/download/file?name=%2e%2e%2fsecret",
        "/player/..%2f..%2f__init__.py",
        "/player/scene.py",
        "/tiles?of=1,../2&edition=1",
        "/film?name=..%2f..%2fetc",
        "/download/zip",
    ],
)
def test_paths_lead_nowhere(server, path):
    status, text = asked(server, "GET", path)
    assert status == 404
    assert "root:" not in text
    assert str(server.project.parent) not in text


def test_another_origins_websocket_is_refused(server):
    place = server.url.replace("http", "ws") + "/_nicegui_ws/socket.io/?EIO=4&transport=websocket"
    with pytest.raises(InvalidStatus) as refused:
        connect(place, origin="http://elsewhere.example", open_timeout=30)
    assert refused.value.response.status_code == 403


def test_another_name_for_this_machine_is_refused(server):
    status, text = asked(server, "GET", "/", {"host": "elsewhere.example"})
    assert (status, "localhost only" in text) == (403, True)


def test_nothing_of_this_machine_is_told(server, visit, tmp_path):
    visitor = visit(server.url)
    visitor.understood("A car turns left.")
    told = visitor.page.content() + json.dumps(visitor.page.evaluate("Object.keys(localStorage)"))
    assert str(server.project.parent) not in told
    assert "Traceback" not in server.log
