"""Transformation from the coordinates of a scan to those of the plate."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Annotated

import numpy as np
import scipy

from haptonic.arrays import Array
from haptonic.errors import ScanError
from haptonic.response import FrequencyResponse
from haptonic.units import In
from haptonic.vibrometry.planning import Region

ROUNDS = 50  # at most in the best fit; it converges in far fewer
SETTLED = 1e-12  # of the plate's size
AS_GOOD = 1.05  # ratio of two misfits that count as equal
SAME_SCALE = 0.05  # relative change of the scale; a larger one gives a remark
WORST = 0.25  # of the size of a plate: a larger misfit means that the points belong to something else


@dataclass(frozen=True, eq=False)
class Registration:
    """plate = scale R(angle) scan + shift, with x reversed before if the plate was seen from behind.

    angle : rad, anticlockwise
    shift : (2,) m
    misfit : rms distance of the point pairs, m
    """

    scale: float
    angle: Annotated[float, In("rad")]
    shift: Annotated[Array, In("m")]
    mirrored: bool
    misfit: Annotated[float, In("m")]

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
        """Remark on a change of the scale that a wrong unit of lengths would cause."""
        if abs(self.scale - 1) <= SAME_SCALE:
            return []
        return [f"lengths were scaled by {self.scale:.4g} to fit the plate: check their unit"]

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

    It starts from the smallest rectangles around both, in all four orientations; of fits that are equally
    good because of the symmetry of a grid, the one with the smallest rotation is used.

    Parameters
    ----------
    scan : (n, 2) measured points, m
    plate : (m, 2) planned points, m; points may be missing on either side

    Raises
    ------
    ScanError : points on a line, or no good fit
    """
    seen = scan * np.array([-1.0, 1.0]) if mirrored else scan
    (size, tilt, middle), (target_size, target_tilt, target) = _rectangle(seen), _rectangle(plate)
    tree, fits = scipy.spatial.cKDTree(plate), list[Registration]()
    for quarter in range(4):
        angle = target_tilt - tilt + quarter * np.pi / 2
        sides = size[::-1] if quarter % 2 else size
        scale = float(np.sqrt(target_size.prod() / sides.prod())) if scaled else 1.0
        fit = Registration(
            scale=scale,
            angle=angle,
            shift=target - scale * _turn(angle) @ middle,
            mirrored=False,
            misfit=np.inf,
        )
        for _ in range(ROUNDS):
            near = plate[tree.query(fit.of(seen))[1]]
            better = register_by_corners(seen, near, scaled=scaled)
            settled = abs(fit.misfit - better.misfit) <= SETTLED * target_size.max()
            fit = better
            if settled:
                break
        fits.append(fit)
    least = min(fit.misfit for fit in fits)
    equal = [fit for fit in fits if fit.misfit <= AS_GOOD * least + 1e-9 * target_size.max()]
    best = min(equal, key=lambda fit: abs(float(np.angle(np.exp(1j * fit.angle)))))
    if best.misfit > WORST * target_size.min():
        raise _wrong("fit", f"a misfit of {best.misfit * 1e3:.4g} mm", "points of the same plate")
    return replace(best, mirrored=mirrored)


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
