"""The server: the page, its pictures and downloads behind the guard."""

import asyncio
import secrets
import webbrowser
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from urllib.parse import quote

import uvicorn
from fastapi import FastAPI
from nicegui import app as pages
from nicegui import ui

from scegen.llm import LlmSettings
from scegen.web import tasks
from scegen.web.deliveries import deliver
from scegen.web.guard import LOOPBACK, Guard
from scegen.web.jobs import Jobs
from scegen.web.models import Models
from scegen.web.page import Page
from scegen.web.project import Project
from scegen.web.sessions import Sessions
from scegen.web.work import Work

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

    ``models`` are those that descriptions can be given to, None for none; ``ready`` is called once
    the page can be opened, and with ``show`` it is opened in a browser too.
    """
    jobs = Jobs(*(["scegen.llm.line"] if models is not None else []))
    application = build(Project(project), jobs, models, cookie=f"scegen_{place.port}")
    guarded = Guard(application, place.token, cookie=f"scegen_key_{place.port}")
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


def build(project: Project, jobs: Jobs, models: LlmSettings | None, *, cookie: str) -> FastAPI:
    """The application without its guard; once in a process. ``cookie`` names its sessions."""
    shared = None if models is None else Models(models)
    sessions = Sessions(lambda: Work(project, jobs, shared))
    application = FastAPI(docs_url=None, redoc_url=None, openapi_url=None)

    @ui.page("/", title=TITLE)
    def index() -> None:
        Page(sessions.of(pages.storage.browser["id"])).build()

    deliver(sessions)
    pages.config.quasar_config["loadingBar"]["skipHijack"] = True
    ui.run_with(
        application,
        title=TITLE,
        favicon=_ICON,
        dark=None,
        language="en-US",
        tailwind=False,
        storage_secret=secrets.token_urlsafe(32),
        session_middleware_kwargs={"same_site": "lax", "session_cookie": cookie},
        show_welcome_message=False,
        reconnect_timeout=10.0,
    )
    return application


_ICON = (
    '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 32 32">'
    '<rect width="32" height="32" rx="7" fill="#1b2330"/>'
    '<path d="M16 3v26M3 16h26" stroke="#6c7683" stroke-width="7"/>'
    '<path d="M18 29V20q0-4 4-4h7" fill="none" stroke="#56b4e9" stroke-width="3" '
    'stroke-linecap="round"/></svg>'
)
