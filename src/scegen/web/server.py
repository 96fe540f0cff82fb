"""The server: the page, its pictures and downloads behind the guard."""

from __future__ import annotations

import asyncio
import secrets
import webbrowser
from collections.abc import Callable
from dataclasses import dataclass
from importlib.resources import files as resources
from pathlib import Path
from urllib.parse import quote

import uvicorn
from fastapi import FastAPI, Request
from fastapi.responses import JSONResponse, PlainTextResponse, Response
from nicegui import app as pages
from nicegui import ui

from scegen.errors import InputError
from scegen.llm import LlmSettings
from scegen.pipeline.folder import SUMMARY_FILE
from scegen.web import tasks
from scegen.web.guard import LOOPBACK, Guard
from scegen.web.jobs import Jobs
from scegen.web.page import Page
from scegen.web.pictures import tile
from scegen.web.project import Project, made_files, zipped
from scegen.web.readme import readme
from scegen.web.sessions import Sessions
from scegen.web.work import Work

MOST_TILES = 60
"""So many pictures are drawn for one request."""
TITLE = "ML-SceGen"


@dataclass(frozen=True, slots=True)
class Address:
    """Where a server listens, and the token that it wants (None on the loopback)."""

    host: str
    port: int
    token: str | None

    @property
    def url(self) -> str:
        """What to open in a browser."""
        shown = f"[{self.host}]" if ":" in self.host else self.host
        key = f"/?token={quote(self.token)}" if self.token else ""
        return f"http://{shown}:{self.port}{key}"


def address(host: str, port: int) -> Address:
    """Where to listen; whoever else can connect must show a token, made anew for every start."""
    return Address(host, port, None if host in LOOPBACK else secrets.token_urlsafe(24))


def serve(
    place: Address,
    project: Path,
    models: LlmSettings | None,
    *,
    ready: Callable[[], None],
    show: bool = False,
) -> None:
    """Serve the page until it is interrupted.

    Args:
        place: where to listen.
        project: the folder of the work.
        models: language models that descriptions can be given to; None for none.
        ready: called once the page can be opened.
        show: open it in a browser too.
    """
    jobs = Jobs()
    guarded = Guard(build(Project(project), jobs, models), place.token)
    server = uvicorn.Server(
        uvicorn.Config(
            guarded,
            host=place.host,
            port=place.port,
            log_level="warning",
            access_log=False,  # addresses hold the token
            server_header=False,
            ws_max_size=1_000_000,
        )
    )

    async def run() -> None:
        task = asyncio.create_task(server.serve())
        while not (server.started or task.done()):
            await asyncio.sleep(0.02)
        if server.started:
            jobs.start("warming up", lambda _: None, tasks.warm)
            ready()
            if show:
                webbrowser.open(place.url)
        await task

    try:
        asyncio.run(run())
    finally:
        jobs.close()


def build(project: Project, jobs: Jobs, models: LlmSettings | None) -> FastAPI:
    """The application without its guard; once in a process."""
    sessions = Sessions(lambda: Work(project, jobs, models))
    application = FastAPI(docs_url=None, redoc_url=None, openapi_url=None)

    @ui.page("/", title=TITLE)
    def index() -> None:
        Page(sessions.of(pages.storage.browser["id"])).build()

    @pages.get("/tiles")
    def tiles(request: Request, of: str, edition: int) -> Response:
        """Pictures of logical scenarios."""
        work = _work(sessions, request)
        listing = work.listing if work else None
        asked = [int(part) for part in of.split(",")[:MOST_TILES] if part.isdecimal()]
        if work is None or listing is None or edition != work.edition:
            return JSONResponse([], 409)
        try:
            drawn = [tile(work.scenario(index), listing.functional) for index in asked]
        except InputError as error:
            return JSONResponse({"message": error.message}, 404)
        return JSONResponse(drawn, headers=_UNKEPT)

    @pages.get("/film")
    def scene(request: Request, name: str) -> Response:
        """What the player plays."""
        work = _work(sessions, request)
        found = work.films.get(name) if work else None
        if found is None:
            return PlainTextResponse("There is no such scene.", 404)
        return Response(found, media_type="application/json", headers=_UNKEPT)

    @pages.get("/player/{name}")
    def player_file(name: str) -> Response:
        """One of the player's modules, or its style sheet."""
        module = _PLAYER.get(name)
        if module is None:
            return PlainTextResponse("There is no such module.", 404)
        kind = "text/css" if name.endswith(".css") else "text/javascript"
        return Response(module, media_type=kind)

    @pages.get("/download/zip")
    def download_zip(request: Request) -> Response:
        """Everything that was made, with a README."""
        work = _work(sessions, request)
        if work is None or work.made is None:
            return PlainTextResponse("Nothing has been made yet.", 404)
        content = zipped(work.made.folder, readme(work))
        return _attached(content, f"{work.made.folder.name}.zip", "application/zip")

    @pages.get("/download/file")
    def download_file(request: Request, name: str) -> Response:
        """One file of what was made; only names that the summary lists are known."""
        work = _work(sessions, request)
        known = {*made_files(work.made.folder), SUMMARY_FILE} if work and work.made else set()
        if work is None or work.made is None or name not in known:
            return PlainTextResponse("There is no such file.", 404)
        file = (work.made.folder / name).resolve()
        if not file.is_relative_to(work.made.folder.resolve()) or not file.is_file():
            return PlainTextResponse("There is no such file.", 404)
        return _attached(file.read_bytes(), file.name, "application/octet-stream")

    ui.run_with(
        application,
        title=TITLE,
        favicon=_ICON,
        dark=None,
        tailwind=False,
        storage_secret=secrets.token_urlsafe(32),
        session_middleware_kwargs={"same_site": "strict"},
        show_welcome_message=False,
        reconnect_timeout=10.0,
    )
    return application


def _work(sessions: Sessions, request: Request) -> Work | None:
    """Whose request it is."""
    return sessions.known(str(request.session.get("id", "")))


def _attached(content: bytes, name: str, kind: str) -> Response:
    """A file to be kept, never shown as part of the page."""
    headers = {"content-disposition": f"attachment; filename*=UTF-8''{quote(name)}"}
    return Response(content, media_type=kind, headers=headers)


_UNKEPT = {"cache-control": "no-store"}
_PLAYER = {
    file.name: file.read_bytes()
    for file in resources("scegen.report.player").iterdir()
    if file.name.endswith((".js", ".css"))
}
"""The player's own files, by name: nothing else of the package can be asked for."""
_ICON = (
    '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 32 32"><rect width="32" height="32" rx="7" '
    'fill="#1b2330"/><path d="M16 3v26M3 16h26" stroke="#6c7683" stroke-width="7"/>'
    '<path d="M18 29V20q0-4 4-4h7" fill="none" stroke="#56b4e9" stroke-width="3" '
    'stroke-linecap="round"/></svg>'
)
