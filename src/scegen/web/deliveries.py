"""What the page fetches beside its elements: pictures, scenes, the player's modules, downloads.

Whose they are is told by the session's cookie; names and numbers are only compared with what the
server knows.
"""

from importlib.resources import files
from urllib.parse import quote

from fastapi import Request
from fastapi.responses import JSONResponse, PlainTextResponse, Response
from nicegui import app as pages

from scegen import __version__
from scegen.pipeline.command import command_line
from scegen.pipeline.folder import SUMMARY_FILE, made_files
from scegen.web.made import Made
from scegen.web.pictures import tile
from scegen.web.project import zipped
from scegen.web.sessions import Sessions
from scegen.web.steps.take_away import MODEL_SPOKE
from scegen.web.work import Work

MOST_TILES = 60
"""So many pictures are drawn for one request."""
_UNKEPT = {"cache-control": "no-store"}
_PLAYER = {
    file.name: file.read_bytes()
    for file in files("scegen.report.player").iterdir()
    if file.name.endswith((".js", ".css"))
}
"""The player's own files, by name: nothing else of the package can be asked for."""
_OUTCOMES = {
    "held": "every check passed, all that was said holds, the target is reached",
    "open": "no check failed and all that was said holds, but something was not reached or not run",
    "failed": "a check failed, or something that was said does not hold; see the report",
}


def deliver(sessions: Sessions) -> None:
    """Add the routes, once in a process."""

    def work_of(request: Request) -> Work | None:
        return sessions.known(str(request.session.get("id", "")))

    @pages.get("/tiles")
    def tiles(request: Request, of: str, edition: int) -> Response:
        work = work_of(request)
        return _nothing("list") if work is None else _tiles(work, of, edition)

    @pages.get("/film")
    def film(request: Request, name: str) -> Response:
        work = work_of(request)
        if work is None or name not in work.films:
            return _nothing("scene")
        return Response(work.films[name], media_type="application/json", headers=_UNKEPT)

    @pages.get("/player/{name}")
    def module(name: str) -> Response:
        if name not in _PLAYER:
            return _nothing("module")
        kind = "text/css" if name.endswith(".css") else "text/javascript"
        return Response(_PLAYER[name], media_type=kind)

    @pages.get("/download/zip")
    def download_zip(request: Request) -> Response:
        work = work_of(request)
        if work is None or work.made is None:
            return _nothing("scenario")
        folder = work.made.folder
        return _attached(zipped(folder, readme(work)), f"{folder.name}.zip", "application/zip")

    @pages.get("/download/file")
    def download_file(request: Request, name: str) -> Response:
        work = work_of(request)
        return _nothing("file") if work is None else _file(work, name)

    @pages.get("/download/picture")
    def download_picture(request: Request, name: str) -> Response:
        work = work_of(request)
        if work is None or name not in work.pictures:
            return _nothing("picture")
        return _attached(work.pictures[name], name)


def _tiles(work: Work, of: str, edition: int) -> Response:
    """Pictures of logical scenarios, as far as they are listed.

    A list may begin anew while a page still asks for the one before: that is no error.
    """
    listing = work.listing
    if listing is None or edition != work.edition:
        return JSONResponse([], headers=_UNKEPT)
    asked = [int(part) for part in of.split(",")[:MOST_TILES] if part.isdecimal()]
    drawn = [tile(one, listing.functional) for one in listing.known(asked)]
    return JSONResponse(drawn, headers=_UNKEPT)


def _file(work: Work, name: str) -> Response:
    """One file of what was made; only names that the summary lists are known."""
    if work.made is None or name not in {*made_files(work.made.folder), SUMMARY_FILE}:
        return _nothing("file")
    folder = work.made.folder.resolve()
    file = (folder / name).resolve()
    if not file.is_relative_to(folder) or not file.is_file():
        return _nothing("file")
    return _attached(file.read_bytes(), file.name)


def _nothing(what: str) -> Response:
    return PlainTextResponse(f"There is no such {what}.", 404)


def _attached(content: bytes, name: str, kind: str = "application/octet-stream") -> Response:
    """A file to be kept, never shown as part of the page."""
    headers = {"content-disposition": f"attachment; filename*=UTF-8''{quote(name)}"}
    return Response(content, media_type=kind, headers=headers)


def readme(work: Work) -> str:
    """What lies in the folder, what was said, and how to make it again."""
    if work.made is None:
        return ""
    made = work.made
    description = made.functional.description if made.functional is not None else ""
    quoted = "\n".join(f"> {line}" for line in description.splitlines())
    rows = "\n".join(f"- `scenarios/{s.name}/`: {_OUTCOMES[s.state]}" for s in made.scenarios)
    return (
        f"# {made.folder.name}\n\n{quoted}\n\n"
        f"Made by ML-SceGen {__version__}. Open `report.html`; it needs no network.\n\n"
        f"{rows}\n\n"
        "Each scenario folder holds `road.xodr` (OpenDRIVE) and `scenario.xosc` (OpenSCENARIO), "
        "`concrete.yaml` with every number, and `proof.json` with every statement of the "
        "description and whether it holds. `functional.yaml` is what was understood, "
        "`logical.json` every way in which it can happen.\n\n"
        f"{_how(made)}"
        "Check and play them:\n\n    scegen check .\n    scegen play .\n"
    )


def _how(made: Made) -> str:
    """The command that makes the files again, where the folder tells it."""
    command = command_line(made.summary, "again")
    if command is None:
        return ""
    spoken = f"{MODEL_SPOKE}\n\n" if "llm" in made.summary else ""
    return f"The same files again, byte for byte:\n\n    {command}\n\n{spoken}"
