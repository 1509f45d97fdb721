"""Who may talk to the studio, with real sockets: each line is a rule of its own."""

import asyncio
import gc
import json
import re
import socket
from pathlib import Path

import pytest
import uvicorn
from served import served
from starlette.routing import Route
from websockets.exceptions import ConnectionClosed, InvalidStatus

from haptonic.studio.guard import LARGEST_BODY
from haptonic.studio.serving import LARGEST_MESSAGE, listen, serve

TEXT = json.dumps({"text": 'title = "x"'}).encode()


@pytest.fixture(scope="module")
def studio(tmp_path_factory):
    folder = tmp_path_factory.mktemp("guarded")
    (folder / "secret.txt").write_text("secret")
    with served(folder) as running:
        yield running


def test_an_admitted_page_is_answered(studio):
    assert studio.ask("GET", "/").status == 200
    assert studio.ask("POST", "/api/check", TEXT).status == 200
    with studio.listening() as live:
        assert json.loads(live.recv())["jobs"] == []


@pytest.mark.parametrize("host", ["evil.example", "evil.example:{port}", "127.0.0.1", "0.0.0.0:{port}", None])
def test_a_foreign_host_is_refused(studio, host):
    given = host and host.format(port=studio.port)
    # without a host the server itself refuses, before it has read a body
    refused, body = (403, TEXT) if host else (400, None)
    assert studio.ask("GET", "/", host=given).status == refused
    assert studio.ask("POST", "/api/check", body, host=given).status == refused


@pytest.mark.parametrize(
    "origin", ["http://evil.example", "http://127.0.0.1", "null", "https://127.0.0.1:{port}", None]
)
def test_a_change_from_another_site_is_refused(studio, origin):
    given = origin and origin.format(port=studio.port)
    assert studio.ask("POST", "/api/check", TEXT, origin=given).status == 403


@pytest.mark.parametrize(
    "cookie", ["", "haptonic-studio-{port}=", "haptonic-studio-{port}=wrong", "a\x7f=;;=", None]
)
def test_a_browser_without_the_cookie_is_refused(studio, cookie):
    given = None if cookie is None else cookie.format(port=studio.port)
    for path in ("/", "/studio.js", "/api/start", "/api/jobs/1"):
        assert studio.ask("GET", path, cookie=given).status == 403
    assert studio.ask("POST", "/api/check", TEXT, cookie=given).status == 403


def test_every_address_needs_the_cookie_and_changes_need_the_origin(studio):
    routes = [route for route in studio.studio.app().routes if isinstance(route, Route)]
    paths = {re.sub(r"{\w+(:int)?}", "1", route.path): route.methods for route in routes}
    assert {"/api/product", "/api/remove", "/api/opened", "/api/jobs/1/page", "/api/jobs/1/points/1"} <= set(
        paths
    )
    for path, methods in paths.items():
        method = "POST" if "POST" in methods else "GET"
        assert studio.ask(method, path, TEXT if method == "POST" else None, cookie=None).status == 403
        if method == "POST":
            assert studio.ask(method, path, TEXT, origin="http://evil.example").status == 403
            assert studio.ask("GET", path).status == 405


@pytest.mark.parametrize(
    "changed",
    [{"Origin": "http://evil.example"}, {"Origin": ""}, {"Cookie": ""}, {"Cookie": "haptonic-studio=x"}],
)
def test_a_websocket_of_another_site_is_refused(studio, changed):
    with pytest.raises(InvalidStatus) as refusal, studio.listening(**changed):
        pass
    assert refusal.value.response.status_code == 403


def test_a_link_works_once_and_its_cookie_is_strict(tmp_path):
    with served(tmp_path, admit=False) as studio:
        assert studio.ask("GET", "/?token=wrong").status == 403
        assert studio.ask("POST", f"/?token={studio.guard.token}", b"").status == 403
        first = studio.ask("GET", f"/?token={studio.guard.token}")
        cookie = first.headers["Set-Cookie"]
        assert first.status == 200
        assert {"httponly", "samesite=strict", "path=/"} <= {
            part.strip().lower() for part in cookie.split(";")
        }
        assert studio.guard.token not in cookie
        assert studio.guard.token.encode() not in first.content
        assert studio.ask("GET", f"/?token={studio.guard.token}").status == 403


@pytest.mark.parametrize(
    "path",
    [
        "/static/../secret.txt", "/../secret.txt", "/..%2fsecret.txt", "/%2e%2e/secret.txt", "/secret.txt",
        "//secret.txt", "/api/jobs/1/pictures/..%2f..%2fsecret.txt", "/studio.js/../secret.txt",
    ],
)  # fmt: skip
def test_no_path_leads_to_a_file(studio, path):
    reply = studio.ask("GET", path)
    assert reply.status == 404
    assert b"secret" not in reply.content


def test_a_large_body_is_refused_with_and_without_its_length(studio):
    assert studio.ask("POST", "/api/check", b" " * (LARGEST_BODY + 1)).status == 413
    with socket.create_connection(("127.0.0.1", studio.port), timeout=60) as raw:
        head = (
            f"POST /api/check HTTP/1.1\r\nHost: 127.0.0.1:{studio.port}\r\nOrigin: {studio.origin}\r\n"
            f"Cookie: {studio.cookie}\r\nTransfer-Encoding: chunked\r\n\r\n"
        )
        raw.sendall(head.encode())
        chunk = b"10000\r\n" + b" " * 0x10000 + b"\r\n"
        for _ in range(LARGEST_BODY // 0x10000 + 1):
            raw.sendall(chunk)
        assert raw.recv(100).startswith(b"HTTP/1.1 413")


def test_a_large_message_ends_the_websocket(studio):
    with studio.listening() as live:
        live.recv()
        live.send("x" * (LARGEST_MESSAGE + 1))
        with pytest.raises(ConnectionClosed):
            live.recv(timeout=20)


def test_messages_are_not_compressed(studio):
    with studio.listening() as live:
        assert "Sec-WebSocket-Extensions" not in live.response.headers


def test_pages_may_run_their_own_program_only(studio):
    for path in ("/", "/studio.js", "/api/start", "/missing"):
        headers = studio.ask("GET", path).headers
        rules = dict(rule.strip().split(" ", 1) for rule in headers["Content-Security-Policy"].split(";"))
        assert rules["default-src"] == "'self'"
        assert "script-src" not in rules
        assert "'none'" in rules["frame-ancestors"]
        assert headers["X-Content-Type-Options"] == "nosniff"
        assert headers["Cache-Control"] == "no-store"
    assert b"<script>" not in studio.ask("GET", "/").content


def test_the_server_listens_on_this_machine_only(studio):
    # a server of all addresses would answer at the second address of the loopback device as well
    with socket.socket() as other:
        other.settimeout(2)
        assert other.connect_ex(("127.0.0.2", studio.port)) != 0
    sources = [path.read_text("utf-8") for path in Path(__file__).parents[2].glob("src/haptonic/studio/*.py")]
    assert not any(word in text for text in sources for word in ("0.0.0.0", "eval(", "shell=True", "pickle"))


@pytest.mark.parametrize("body", [b"[]", b"{", b"[" * 100_000, b"\xff", b'{"text": 1}', b'{"text": null}'])
def test_a_request_that_is_not_the_pages_is_refused(studio, body):
    assert studio.ask("POST", "/api/check", body).status in (400, 422)


def test_a_server_collects_garbage_as_often_as_python_by_itself(monkeypatch, tmp_path):
    usual, during = gc.get_threshold(), []

    def run(server: uvicorn.Server, sockets: list[socket.socket]) -> None:
        during.append(gc.get_threshold())
        sockets[0].close()

    monkeypatch.setattr(uvicorn.Server, "run", run)
    monkeypatch.chdir(tmp_path)
    gc.set_threshold(200_000)
    try:
        serve(None, 0, lambda link: None)
    finally:
        gc.set_threshold(*usual)
    assert during == [usual]


def test_answers_are_sent_without_delay():
    # otherwise the second part of each answer waits until the browser confirms the first, which takes 40 ms
    async def is_at_once() -> bool:
        accepted = asyncio.get_running_loop().create_future()
        server = await asyncio.start_server(lambda _, writer: accepted.set_result(writer), sock=listen(0))
        async with server:
            _, page = await asyncio.open_connection(*server.sockets[0].getsockname())
            answering = await accepted
            connection = answering.get_extra_info("socket")
            at_once = connection.getsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY)
            page.close()
            answering.close()
        return bool(at_once)

    assert asyncio.run(is_at_once())
