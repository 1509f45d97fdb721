"""Addresses of what belongs to a number that is turned: first curves, sliders and previews of a job."""

from __future__ import annotations

from starlette.requests import Request
from starlette.responses import JSONResponse, PlainTextResponse, Response
from starlette.routing import Route

from haptonic.studio.jobs import Jobs

LONGEST_PATH = 300  # characters


def turn_routes(jobs: Jobs) -> list[Route]:
    """Routes below the address of a job."""

    async def first(request: Request) -> Response:
        job = jobs.jobs.get(request.path_params["number"])
        return _binary(None if job is None else job.first)

    async def knobs(request: Request) -> Response:
        job = jobs.jobs.get(request.path_params["number"])
        return _missing() if job is None or job.knobs is None else JSONResponse(job.knobs)

    async def preview(request: Request) -> Response:
        job, place = jobs.jobs.get(request.path_params["number"]), request.path_params["knob"]
        if job is None or job.knobs is None or place >= len(job.knobs):
            return _missing()
        _, view = job.previews.get(job.knobs[place]["path"], (0, None))
        return _binary(view)

    return [
        Route("/api/jobs/{number:int}/first", first),
        Route("/api/jobs/{number:int}/knobs", knobs),
        Route("/api/jobs/{number:int}/previews/{knob:int}", preview),
    ]


def _binary(content: bytes | None) -> Response:
    return _missing() if content is None else Response(content, media_type="application/octet-stream")


def _missing() -> Response:
    return PlainTextResponse("There is no such part of a job.", 404)
