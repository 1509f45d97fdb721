"""Reception of files: each is of use, complete or absent, and replaces another one only if asked."""

from __future__ import annotations

import errno
import secrets
from collections.abc import AsyncIterator, Callable
from contextlib import suppress
from pathlib import Path, PurePosixPath

from starlette.concurrency import run_in_threadpool
from starlette.requests import Request
from starlette.responses import JSONResponse, PlainTextResponse, Response
from starlette.routing import Route

from haptonic.atomic import TEMPORARY, cause_of
from haptonic.cell.solid import DRAWN, MESHES
from haptonic.channels.formats import HEAD, SUFFIXES, recognised
from haptonic.errors import HaptonicError, ResourceError, StudyError, shown
from haptonic.studio.checking import described
from haptonic.studio.guard import UPLOAD, TooLargeError
from haptonic.studio.workspace import Workspace
from haptonic.study.template import ENDING

SOLIDS = (*DRAWN, *MESHES)  # endings of files that a study names


def upload_route(workspace: Workspace, listed: Callable[[], object]) -> Route:
    """The address that takes a file, and answers with the files that are there afterwards."""

    async def upload(request: Request) -> Response:
        asked = request.query_params
        name, replace = asked.get("name", ""), asked.get("replace") == "1"
        try:
            await receive(workspace, name, request.stream(), replace=replace)
        except TooLargeError:
            return PlainTextResponse("The file is too large.", 413)
        except HaptonicError as error:
            return JSONResponse({"error": described(error, {})}, 422)
        return JSONResponse(await run_in_threadpool(listed))

    return Route(UPLOAD, upload, methods=["POST"])


async def receive(
    workspace: Workspace, name: str, content: AsyncIterator[bytes], *, replace: bool = False
) -> None:
    """Write a file of the workspace from its content.

    Raises
    ------
    StudyError : a name that leads out of the folder, or one that is taken; or a file of no use
    ResourceError : the folder cannot be written, or the disk is full
    """
    path = workspace.place(name)
    draft: Path | None = None
    try:
        if not replace:
            await run_in_threadpool(_need_free, path, name)
        head = await _head(content)
        _need_use(name, head)
        await run_in_threadpool(path.parent.mkdir, parents=True, exist_ok=True)
        draft = path.parent / f"{TEMPORARY}{secrets.token_hex(8)}.tmp"
        with draft.open("xb") as file:
            await run_in_threadpool(file.write, head)
            async for part in content:
                await run_in_threadpool(file.write, part)
        await run_in_threadpool(_put, draft, path, name, replace)
    except OSError as error:
        raise ResourceError.unwritable(
            argument="name of the file",
            given=shown(name, 200),
            allowed="a file in a folder that can be written, with room for it",
            cause=cause_of(error),
            next_step="choose another name, or make room on the disk",
        ) from error
    finally:
        if draft is not None:
            with suppress(OSError):
                draft.unlink(missing_ok=True)


async def _head(content: AsyncIterator[bytes]) -> bytes:
    """First bytes of a file, enough to recognise its format."""
    head = b""
    async for part in content:
        head += part
        if len(head) >= HEAD:
            break
    return head


def _need_use(name: str, head: bytes) -> None:
    """Refuse a file that neither an analysis nor a study reads, before it is written."""
    suffix = PurePosixPath(name).suffix.lower()
    if not name.endswith(ENDING) and suffix not in SOLIDS and recognised(suffix, head) is None:
        raise StudyError.unsupported(
            argument="file",
            given=shown(name, 200),
            allowed=f"a study ({ENDING}), a measurement ({', '.join(SUFFIXES)}), or a CAD file or mesh "
            f"of a cell ({', '.join(SOLIDS)})",
            cause="neither an analysis nor a study reads this format",
            next_step="save a measurement as CSV, or a cell as STEP, and drop that file",
        )


def _need_free(path: Path, name: str) -> None:
    if path.is_symlink() or path.exists():
        raise _taken(name)


def _put(draft: Path, path: Path, name: str, replace: bool) -> None:
    """Move a complete file to its place; the name is reserved first, so that no other file is replaced."""
    if path.is_dir():
        raise IsADirectoryError(errno.EISDIR, "")
    if not replace:
        try:
            path.open("xb").close()
        except FileExistsError:
            raise _taken(name) from None
    draft.replace(path)


def _taken(name: str) -> StudyError:
    return StudyError.repeated(
        argument="name of the file",
        given=shown(name, 200),
        allowed="a new name, or one whose file may be replaced",
        cause="a file of this name is in the folder",
        next_step="choose another name, or replace the file",
    )
