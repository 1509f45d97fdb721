"""Transformation from the coordinates of a scan to those of the plate."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from operator import attrgetter
from typing import Annotated

import numpy as np
import scipy

from haptonic.arrays import Array
from haptonic.errors import ScanError
from haptonic.response import FrequencyResponse
from haptonic.units import In, in_percent
from haptonic.vibrometry.planning import Region

ROUNDS = 50  # at most in the best fit; it converges in far fewer
SETTLED = 1e-12  # of the plate's size
AS_GOOD = 1.05  # ratio of two misfits that count as equal
ON_THE_PLAN = 0.02  # of the step of the plan: points this near to planned ones lie on them
MUCH_BETTER = 0.5  # ratio of misfits for which another scale is taken
STRAY = 3.0  # times the usual distance of neighbours, for a point that is left out of the fit
SAME_SCALE = 0.05  # relative change of the scale; a larger one gives a remark
WHOLE = 0.8  # of the planned points; a scan that covers less gives a remark
WORST = 0.25  # of the size of a plate: a larger misfit means that the points belong to something else


@dataclass(frozen=True, eq=False)
class Registration:
    """plate = scale R(angle) scan + shift, with x reversed before if the plate was seen from behind.

    angle : rad, anticlockwise
    shift : (2,) m
    misfit : rms distance of the point pairs, m
    repeats : shift by a step of the plan that fits as well, (2,) m, if any
    covered : share of the planned points that have a point of the scan beside them; 1 without a plan
    """

    scale: float
    angle: Annotated[float, In("rad")]
    shift: Annotated[Array, In("m")]
    mirrored: bool
    misfit: Annotated[float, In("m")]
    repeats: Annotated[Array | None, In("m")] = None
    covered: float = 1.0

    @property
    def sentence(self) -> str:
        """The transformation and its misfit in words."""
        x, y = 1e3 * self.shift
        return (
            f"Registered: scale {self.scale:.5f}, turned by {np.degrees(self.angle):.3f}°, "
            f"{'seen from behind, ' if self.mirrored else ''}shifted by {x:.3f} and {y:.3f} mm; misfit "
            f"{self.misfit * 1e3:.3f} mm."
        )

    @property
    def doubts(self) -> list[str]:
        """Remarks on a scale that a wrong unit of lengths would cause, and on other equally good places."""
        remarks = []
        if self.covered < WHOLE:
            remarks.append(
                f"the points cover {in_percent(self.covered)} of the plan: a part of the plate was scanned, "
                "or another plate; check the registration"
            )
        if abs(self.scale - 1) > SAME_SCALE:
            remarks.append(f"lengths were scaled by {self.scale:.4g} to fit the plate: check their unit")
        if self.repeats is not None:
            x, y = 1e3 * self.repeats
            remarks.append(
                f"the points fit the plan equally well {x:.3g} mm farther along x and {y:.3g} mm along y: "
                "give the corners of the plate in the scan (--corners)"
            )
        return remarks

    def of(self, points: Array) -> Array:
        """(point, 2) positions on the plate of points of the scan, m."""
        turned = points * np.array([-1.0, 1.0]) if self.mirrored else points
        return np.asarray(self.scale * turned @ _turn(self.angle).T + self.shift)

    def registered(
        self, response: FrequencyResponse, regions: Mapping[str, Region] | None = None
    ) -> FrequencyResponse:
        """The response at its positions on the plate, with the names of the regions of its points.

        Parameters
        ----------
        regions : by name; a point in several belongs to the first; None leaves the response's names

        Raises
        ------
        ScanError : motions within the plate, whose directions would have to be rotated
        """
        data, notes = response.dataset, response.dataset.attrs
        directions = [str(name) for name in data["direction"].values]
        if directions != ["z"] and (self.mirrored or abs(self.angle) > 1e-12):
            raise ScanError.unsupported(
                argument="registration",
                given=f"a turn by {np.degrees(self.angle):.4g} deg of motions along {', '.join(directions)}",
                allowed="motions along z, or a registration without a turn",
                cause="in-plane motions turn with the coordinates",
                next_step="turn the scan in the instrument's program, or keep z only",
            )
        points = self.of(response.points)
        names = [str(name) for name in data["region"].values] if "region" in data.coords else None
        if regions is not None:
            names = [""] * len(points)
            for name, region in reversed(list(regions.items())):
                for number in np.flatnonzero(region.holds(points)):
                    names[number] = name
        registration = {
            "scale": self.scale,
            "angle": self.angle,
            "shift": self.shift.tolist(),
            "misfit": self.misfit,
        }
        return FrequencyResponse.of(
            response.values, frequency=response.frequency,
            x=points[:, 0].copy(), y=points[:, 1].copy(), direction=directions, region=names,
            quantity=notes["quantity"], reference=notes["reference"], origin=notes["origin"],
            coherence=data["coherence"].values if "coherence" in data else None, title=notes["title"],
            inputs=json.loads(notes["inputs"]) | {"registration": registration | {"mirrored": self.mirrored}},
        )  # fmt: skip


def register_by_corners(
    scan: Array, plate: Array, *, scaled: bool = True, mirrored: bool = False
) -> Registration:
    """Least-squares registration from pairs of points, such as the plate's corners [umeyama1991].

    Parameters
    ----------
    scan, plate : (n, 2) the same n >= 2 positions in both coordinates, m
    scaled : let the scale differ from 1
    mirrored : True if the plate was seen from behind

    Raises
    ------
    ScanError : unequal numbers of points, or all at one position
    """
    if scan.shape != plate.shape or scan.ndim != 2 or scan.shape[1:] != (2,) or len(scan) < 2:
        raise _wrong("corners", f"{scan.shape} and {plate.shape}", "two or more pairs of points, (n, 2) each")
    if not (np.isfinite(scan).all() and np.isfinite(plate).all()):
        raise _wrong("corners", "coordinates that are not finite", "finite coordinates")
    seen = scan * np.array([-1.0, 1.0]) if mirrored else scan
    middle, target = seen.mean(axis=0), plate.mean(axis=0)
    a, b = seen - middle, plate - target
    spread = float((a**2).sum())
    if spread == 0 or (b**2).sum() == 0:
        raise _wrong("corners", "all points on one place", "points that are apart")
    # as a complex number, rotation and scale are one factor
    za, zb = a[:, 0] + 1j * a[:, 1], b[:, 0] + 1j * b[:, 1]
    factor = complex((za.conj() * zb).sum()) / spread
    scale, angle = (abs(factor) if scaled else 1.0), float(np.angle(factor))
    if scale == 0:
        raise _wrong("corners", "pairs without any common turn", "the same places in the same order")
    shift = target - scale * _turn(angle) @ middle
    left = scale * seen @ _turn(angle).T + shift - plate
    return Registration(
        scale=scale,
        angle=angle,
        shift=shift,
        mirrored=mirrored,
        misfit=float(np.sqrt((left**2).sum(axis=1).mean())),
    )


def register_by_fit(
    scan: Array, plate: Array, *, scaled: bool = True, mirrored: bool = False
) -> Registration:
    """Best fit of all points of a scan to the planned ones, each to its nearest (iterative closest points).

    A scan whose points lie on planned ones is not moved. Otherwise the fit starts from the points as they
    are, and from the smallest rectangles around both in all four orientations. Of fits that are equally good
    because of the symmetry of a grid, the one with the smallest rotation and then the smallest shift is used.
    Another scale than 1 is taken only if it fits much better. Single points far from all others are left out.

    Parameters
    ----------
    scan : (n, 2) measured points, m
    plate : (m, 2) planned points, m; points may be missing on either side

    Raises
    ------
    ScanError : points on a line, or no good fit
    """
    seen = scan * np.array([-1.0, 1.0]) if mirrored else scan
    if len(seen) > 2:
        apart = _distances(seen)
        seen = seen[apart <= STRAY * np.median(apart)]
    plan, sure = _PlanPoints(plate), ON_THE_PLAN * float(np.median(_distances(plate)))
    given = Registration(scale=1.0, angle=0.0, shift=np.zeros(2), mirrored=False, misfit=np.inf)
    given = replace(given, misfit=plan.misfit(given, seen))
    if given.misfit <= sure and not mirrored:
        return replace(given, covered=plan.covered(given, seen))
    best = _nearest_fit([given, *_starts(seen, plate, scaled=False)], seen, plan, sure, scaled=False)
    if scaled and best.misfit > sure:
        other = _nearest_fit(_starts(seen, plate, scaled=True), seen, plan, sure, scaled=True)
        best = other if other.misfit < MUCH_BETTER * best.misfit else best
    if best.misfit > WORST * np.ptp(plate, axis=0).min():
        raise _wrong("fit", f"a misfit of {best.misfit * 1e3:.4g} mm", "points of the same plate")
    repeats = [fit for fit in plan.stepped(best) if plan.misfit(fit, seen) <= AS_GOOD * best.misfit + sure]
    if repeats:
        best = replace(best, repeats=repeats[0].shift - best.shift)
    return replace(best, mirrored=mirrored, covered=plan.covered(best, seen))


class _PlanPoints:
    """Planned points (m, 2), m, and their neighbours."""

    def __init__(self, points: Array) -> None:
        self.points, self.tree = points, scipy.spatial.cKDTree(points)

    def near(self, points: Array) -> Array:
        """(n, 2) planned point nearest to each of the points."""
        return np.asarray(self.points[self.tree.query(points)[1]])

    def misfit(self, fit: Registration, seen: Array) -> float:
        """Root mean square distance of the moved points to the nearest planned ones, m."""
        return float(np.sqrt((self.tree.query(fit.of(seen))[0] ** 2).mean()))

    def covered(self, fit: Registration, seen: Array) -> float:
        """Share of the planned points that have a moved point beside them."""
        points = fit.of(seen)
        step = max(float(np.median(_distances(places))) for places in (points, self.points))
        return float((scipy.spatial.cKDTree(points).query(self.points)[0] <= step).mean())

    def stepped(self, fit: Registration) -> list[Registration]:
        """A registration shifted by each of the steps."""
        return [replace(fit, shift=fit.shift + step) for step in self.steps]

    @cached_property
    def steps(self) -> list[Array]:
        """Shifts by one step of the grid, to both sides along x and y."""
        tolerance = 1e-6 * np.ptp(self.points)
        apart = [np.diff(np.unique(self.points[:, axis])) for axis in (0, 1)]
        sizes = [gaps[gaps > tolerance].min(initial=np.inf) for gaps in apart]
        unit = np.eye(2)
        return [
            sign * sizes[axis] * unit[axis] for axis in (0, 1) if np.isfinite(sizes[axis]) for sign in (1, -1)
        ]


def _starts(seen: Array, plate: Array, *, scaled: bool) -> list[Registration]:
    """Registrations that place the smallest rectangle around the points on that of the plate."""
    (size, tilt, middle), (target_size, target_tilt, target) = _rectangle(seen), _rectangle(plate)
    starts = []
    for quarter in range(4):
        angle = target_tilt - tilt + quarter * np.pi / 2
        scale = float(np.sqrt(target_size.prod() / size.prod())) if scaled else 1.0
        shift = target - scale * _turn(angle) @ middle
        starts.append(Registration(scale=scale, angle=angle, shift=shift, mirrored=False, misfit=np.inf))
    return starts


def _nearest_fit(
    starts: Sequence[Registration], seen: Array, plan: _PlanPoints, sure: float, *, scaled: bool
) -> Registration:
    """Least turned and least moved of the best fits that these registrations lead to."""
    fits = [_settled(start, seen, plan, scaled=scaled) for start in starts]
    least = min(fit.misfit for fit in fits)
    equal = [fit for fit in fits if fit.misfit <= AS_GOOD * least + sure]
    best = min(
        equal,
        key=lambda fit: (
            round(abs(float(np.angle(np.exp(1j * fit.angle)))), 3),
            float(((fit.of(seen) - seen) ** 2).mean()),
        ),
    )
    while True:  # points that are too many at one side have moved the grid by a step or more
        by_step = min(
            (_settled(start, seen, plan, scaled=scaled) for start in plan.stepped(best)),
            key=attrgetter("misfit"),
        )
        if by_step.misfit >= best.misfit - sure:
            return best
        best = by_step


def _settled(fit: Registration, seen: Array, plan: _PlanPoints, *, scaled: bool) -> Registration:
    """The best fit that a registration leads to, each point with its nearest planned one."""
    for _ in range(ROUNDS):
        better = register_by_corners(seen, plan.near(fit.of(seen)), scaled=scaled)
        if abs(fit.misfit - better.misfit) <= SETTLED * np.ptp(plan.points, axis=0).max():
            return better
        fit = better
    return fit


def _distances(points: Array) -> Array:
    """(n,) distance of each point to its nearest neighbour, m."""
    return np.asarray(scipy.spatial.cKDTree(points).query(points, k=2)[0][:, 1])


def _rectangle(points: Array) -> tuple[Array, float, Array]:
    """Sides, rotation and middle of the smallest rectangle around points; one side lies on the hull's."""
    try:
        hull = points[scipy.spatial.ConvexHull(points).vertices]
    except (scipy.spatial.QhullError, ValueError) as error:
        raise _wrong(
            "fit", f"{len(points)} points on one line", "three points or more, not on a line"
        ) from error
    sides = np.diff(np.vstack([hull, hull[:1]]), axis=0)
    boxes = []
    for tilt in np.arctan2(sides[:, 1], sides[:, 0]):
        turned = hull @ _turn(float(-tilt)).T
        low, high = turned.min(axis=0), turned.max(axis=0)
        boxes.append((high - low, float(tilt), _turn(float(tilt)) @ (low + high) / 2))
    return min(boxes, key=lambda box: float(box[0].prod()))


def _turn(angle: float) -> Array:
    return np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])


def _wrong(argument: str, given: str, allowed: str) -> ScanError:
    return ScanError.malformed(
        argument=f"registration.{argument}",
        given=given,
        allowed=allowed,
        cause="points of another scan or in another order, or millimetres for metres",
        next_step="give the same places in both coordinates, in m",
    )
