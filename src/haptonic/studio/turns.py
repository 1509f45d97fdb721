"""Addresses for a number that is turned: first curves, sliders and previews of a job."""

from __future__ import annotations

from starlette.requests import Request
from starlette.responses import JSONResponse, Response
from starlette.routing import Route

from haptonic.studio.jobs import Jobs
from haptonic.studio.replies import binary, missing

LONGEST_PATH = 300  # characters


def turn_routes(jobs: Jobs) -> list[Route]:
    """Routes below the address of a job."""

    async def first(request: Request) -> Response:
        job = jobs.jobs.get(request.path_params["number"])
        return binary(None if job is None else job.first[1])

    async def knobs(request: Request) -> Response:
        job = jobs.jobs.get(request.path_params["number"])
        return missing() if job is None or job.knobs is None else JSONResponse(job.knobs)

    async def preview(request: Request) -> Response:
        job, place = jobs.jobs.get(request.path_params["number"]), request.path_params["knob"]
        if job is None or job.knobs is None or place >= len(job.knobs):
            return missing()
        _, view = job.previews.get(job.knobs[place]["path"], (0, None))
        return binary(view)

    return [
        Route("/api/jobs/{number:int}/first", first),
        Route("/api/jobs/{number:int}/knobs", knobs),
        Route("/api/jobs/{number:int}/previews/{knob:int}", preview),
    ]
