"""Checks of a stack: its discs form one body with the plate, and a mesh can follow them."""

from __future__ import annotations

import math

import numpy as np

from haptonic.cell.blocks import VOID
from haptonic.cell.disc import STEEPEST
from haptonic.cell.outlines.outline import SAME
from haptonic.cell.pillar import LEAST_SHARE
from haptonic.cell.stack import LEAST_APART, Stack
from haptonic.fields import problem
from haptonic.units import format_quantity


def check_stack(stack: Stack, table: str) -> None:
    """Refuse discs that form no body with the plate, or one that changes nothing.

    table : table of the study with the discs, with a dot at its end; errors give a disc by its number
    """
    _check_ends(stack, table)
    _check_borders(stack, table)
    for number in range(len(stack.discs)):
        if stack.grid_without(number) == stack.grid:
            raise problem(
                "conflict",
                "a disc that changes nothing",
                "discs of a material, empty ones, and those that are above the plate",
                "it has the material that is there without it, is empty where nothing is, or later discs "
                "replace it",
                "give it another material, move it, or leave it out; empty = true makes a hole in the plate",
                at=f"{table}disc[{number + 1}]",
            )
    _check_joined(stack, table)


def _check_ends(stack: Stack, table: str) -> None:
    for number, disc in enumerate(stack.discs, start=1):
        low, high = disc.ends(stack.thickness)
        if low < -SAME * stack.thickness:
            raise problem(
                "out-of-range",
                format_quantity(low - stack.thickness, "m"),
                f"at least {format_quantity(-stack.thickness, 'm')}, the plate's lower face",
                "the disc reaches out of the plate below",
                'leave low out for a disc through the plate; faces = "both" gives its image below',
                at=f"{table}disc[{number}].low",
            )
        if high <= stack.heights[0]:
            raise problem(
                "out-of-range",
                format_quantity(high - stack.thickness, "m"),
                f"above the plate's middle plane, {format_quantity(-0.5 * stack.thickness, 'm')}",
                "discs on both faces are given by those of the upper half",
                'give its image in the upper half, or write faces = "one"',
                at=f"{table}disc[{number}].high",
            )
        (width, _), (other, _) = disc.side(stack.thickness)
        if min(width, other) < LEAST_SHARE * max(width, other):
            inwards, outwards = (
                math.degrees(math.atan(width * change / (high - low)))
                for change in (1 - LEAST_SHARE, 1 / LEAST_SHARE - 1)
            )
            most = math.degrees(STEEPEST)
            raise problem(
                "out-of-range",
                f"{math.degrees(disc.draft):g} deg",
                f"between {-min(outwards, most):.3g} and {min(inwards, most):.3g} degrees for these sizes",
                "one end would almost vanish beside the other, or the sides would meet",
                "choose a smaller angle, or let the disc end earlier",
                at=f"{table}disc[{number}].draft",
            )
    thinnest = float(np.diff(stack.heights).min())
    if thinnest < LEAST_APART * stack.thickness:
        raise problem(
            "out-of-range",
            f"ends that are {format_quantity(thinnest, 'm', digits=3)} apart",
            f"equal ends, or ends at least {format_quantity(LEAST_APART * stack.thickness, 'm')} apart",
            "a layer as thin as that has no mesh",
            "make the two ends equal, or the layer thicker",
            at=f"{table}disc",
        )


def _check_borders(stack: Stack, table: str) -> None:
    """Refuse borders that cross or touch, or are nearly the same."""
    least, widths = LEAST_APART * stack.borders[-1].half_width, stack.rings(stack)
    if widths.min(initial=np.inf) < least:
        border, end = np.unravel_index(widths.argmin(), widths.shape)
        inner, outer = (
            format_quantity(2 * width, "m", digits=9) for width in stack.widths[border : border + 2, end]
        )
        level = format_quantity(stack.heights[end] - stack.thickness, "m")
        raise problem(
            "out-of-range",
            f"sections of {inner} and {outer} whose outlines cross or nearly touch at the height {level}",
            f"equal sections, or one at least {format_quantity(least, 'm', digits=3)} inside another",
            "the borders of a stack lie inside each other at every height; beyond its discs a border is "
            "upright",
            "make the inner one smaller, or the two equal; a cone continues a disc that ends where it "
            "begins, with the same width",
            at=f"{table}disc",
        )


def _check_joined(stack: Stack, table: str) -> None:
    """Refuse parts without contact to the rest, or with contact along an edge only."""
    solid = np.array(stack.grid) != VOID
    joined = np.zeros_like(solid)
    joined[: stack.in_plate, -1] = True
    while True:
        more = joined.copy()
        more[1:] |= joined[:-1]
        more[:-1] |= joined[1:]
        more[:, 1:] |= joined[:, :-1]
        more[:, :-1] |= joined[:, 1:]
        more &= solid
        if (more == joined).all():
            break
        joined = more
    grid = np.pad(solid, ((1, 1), (0, 0)))
    inner, outer = grid[:, :-1], grid[:, 1:]
    rising, falling = inner[:-1] & outer[1:], outer[:-1] & inner[1:]
    neither = ~(outer[:-1] | inner[1:]), ~(inner[:-1] | outer[1:])
    edges = (rising & neither[0]) | (falling & neither[1])
    if (joined != solid).any() or edges.any():
        raise problem(
            "conflict",
            "a part that touches the plate along an edge only"
            if edges.any()
            else "a part that the plate does not carry",
            "discs that make one body with the plate",
            "between the part and the plate there is nothing; heights are those above the plate's upper face",
            "let the ends of the discs meet (on the plate, low is 0), or leave the part out",
            at=f"{table}disc",
        )
