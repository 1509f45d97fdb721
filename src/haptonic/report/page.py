"""The chapters, a head and an appendix as one file that needs no other."""

from __future__ import annotations

import itertools
import json
import platform
from dataclasses import replace
from importlib.metadata import version
from pathlib import Path
from typing import Any

import numpy as np

from haptonic import plots
from haptonic.atomic import refuse_overwrite, write_atomically
from haptonic.bloch import gaps_of
from haptonic.cell import UnitCell
from haptonic.fields import Quantity, table
from haptonic.fields.keys import key_of, leaves
from haptonic.materials import Material, built_in_name
from haptonic.pages import filled
from haptonic.plots.text import gap_text
from haptonic.report.chapter import Absent, Chapter, Results, Table
from haptonic.report.chapters import IN_ORDER, others
from haptonic.report.first import first_screen
from haptonic.study.named import expressions_of
from haptonic.study.schema import Description
from haptonic.units import format_quantity, hz_text
from haptonic.views import digest, embedded_data, program

TEMPLATE = "page.html"
MOST_FINDINGS = 3  # of a chapter that are seen while it is folded
MESH = {
    "order": "Order of the elements around the pillar and in the core",
    "outward": "Order across the rings",
    "upward": "Order along z in the plate",
    "along": "Order along z in the pillar",
    "thin": "Order across the thin rings and layers",
    "foot_rings": "Thin rings on either side of the pillar's foot",
    "step_rings": "Thin rings on either side of its step",
    "bridges": "Rings inside and outside, layers above and below that lead from the thin ones to the rest",
    "pillar_layers": "Layers of elements in the pillar",
    "step_layers": "Layers of elements above its step",
    "blocks": "Elements along a side of the core",
    "plate_layers": "Layers of elements in the plate",
    "sides": "Sides of the tile",
    "levels": "Nodes through the thickness where tiles meet, 0 if its own",
    "near_rim": "Nodes through the thickness at the rim beyond those elsewhere",
    "rim": "Pieces of a side where tiles meet and order on each, 0 for those of the elements",
    "stack": "Layers and rings of the discs",
}  # of the fields of a `haptonic.cell.MeshPlan`
LIBRARIES = ("haptonic", "numpy", "scipy", "xarray", "matplotlib", "meshio")


def write_report(results: Results, path: Path, overwrite: bool = False) -> Path:
    """Write the report as one HTML file with everything inside: pictures, style, interactive views.

    Raises
    ------
    ResourceError : the file exists and ``overwrite`` is False, or it cannot be written
    """
    refuse_overwrite(path, overwrite)
    content = page(results).encode()
    write_atomically(path, lambda temporary: temporary.write_bytes(content))
    return path


def page(results: Results) -> str:
    """The report as text."""
    with plots.chosen("column"):  # a column fits a telephone, and two of them a screen
        return _page(results)


def _page(results: Results) -> str:
    parts = [chapter(results) for chapter in IN_ORDER] + others(results)
    known, count, chapters = results.references, itertools.count(1), []
    for part in parts:
        if isinstance(part, Chapter):
            remarks = known.remarks(part.identifier) if known else []
            pictures = tuple(replace(picture, number=next(count)) for picture in part.pictures)
            chapters.append(replace(part, findings=(*part.findings, *remarks), pictures=pictures))
    return filled(
        TEMPLATE,
        study=results.study,
        first=first_screen(results, chapters),
        most=MOST_FINDINGS,
        facts=_key_numbers(results),
        chapters=chapters,
        views={place: embedded_data(view) for part in chapters for place, (_, view) in part.opened.items()},
        program=program(),
        digest=digest(),
        absent=[part for part in parts if isinstance(part, Absent)],
        appendix=_appendix(results),
        version=version("haptonic"),
    )


def _key_numbers(results: Results) -> list[tuple[str, str]]:
    study = results.study
    cell = study.cell
    sizes = [f"pitch {_length(cell.lattice.pitch)}", f"plate {_length(cell.thickness)}"]
    for pillar in dict.fromkeys(pillar for pillar in cell.pillars if pillar is not None):
        long = f", {_length(pillar.length)} long" if pillar.length else ""
        sizes.append(
            f"{pillar.section} pillar {_length(pillar.diameter)} wide{long}, {_length(pillar.height)} high"
        )
    sizes += [disc.text(cell.thickness) for disc in cell.discs.values()]
    if cell.solid is not None:
        source = "mesh taken as it is from" if cell.solid.is_mesh else "solids of"
        sizes.append(f"{source} {Path(cell.solid.file).name}")
    complete = [gap for gap in gaps_of(results.bands) if gap.complete and gap.certain]
    facts = [
        ("Unit cell", f"{cell.lattice.name} lattice; {'; '.join(sizes)}"),
        ("Material", _materials(cell)),
        ("Carrier", "not given" if study.carrier is None else hz_text(study.carrier, form="g")),
    ]
    if len(complete) > 1:
        facts.append(("Complete gaps", "; ".join(gap_text(gap) for gap in complete)))
    if results.started is not None:
        facts.append(("Computed", results.started.strftime("%d %B %Y, %H:%M %Z").strip()))
    return facts


def _materials(cell: UnitCell) -> str:
    """Names of the cell's materials, the plate's first."""
    plate, *others = dict.fromkeys(_solid(solid) for solid in cell.materials.values())
    return plate if not others else f"{plate}; {cell.parts} of {' and '.join(others)}"


def _solid(solid: Material) -> str:
    """Name of a material, and the turn of its axes if it has one."""
    turn = getattr(solid, "turn", 0.0)
    return f"{solid.name} (turned by {format_quantity(turn, 'rad')})" if turn else solid.name


def _length(value: float) -> str:
    return format_quantity(value, "m")


def _appendix(results: Results) -> Chapter:
    tables = [part(results) for part in (_inputs, _mesh, _model, _errors, _versions)]
    if results.timings:
        rows = tuple((name, f"{seconds:.1f}") for name, seconds in results.timings.items())
        tables.append(Table("Run times. Products from the store take no time.", ("Product", "Seconds"), rows))
    return Chapter(
        title="Appendix: inputs, errors, versions",
        identifier="appendix",
        paragraphs=(
            "Every error is a bound that rests on the residual of the reduced solution in the full model and "
            "on a comparison with a coarser mesh.",
        ),
        tables=tuple(tables),
    )


def _inputs(results: Results) -> Table:
    """Every key that has a value, defaults included, and the constants of a material given by name."""
    study, keys, rows = results.study, table(Description), []
    expressions = expressions_of(study)
    for path, value, quantity in leaves(study):
        key = key_of(path, keys)
        assert key is not None, path
        formula = f" = {expressions[path]}" if path in expressions else ""
        rows.append((path, key.title, f"{_shown(value, quantity)}{formula}"))
    for at, solid in study.cell.materials.items():
        if built_in_name(solid):
            name = at if at == "material" else f"cell.{at}"
            rows.append((f"{name}: kind", "", str(solid.to_dict()["kind"])))
            rows += [(f"{name}: {path}", "", _shown(value, unit)) for path, value, unit in leaves(solid)]
    return Table("Inputs, defaults included.", ("Key", "Title", "Value"), tuple(rows))


def _shown(value: Any, quantity: Quantity | None) -> str:
    return format_quantity(value, quantity.unit) if quantity else str(value) or "-"


def _mesh(results: Results) -> Table:
    """The plan of every tile."""
    plans = json.loads(results.bands.attrs["mesh"])
    plans = [plans] if isinstance(plans, dict) else plans  # a cell of a single tile has one plan
    heads = [f"Tile {number}" for number in range(1, len(plans) + 1)] if len(plans) > 1 else ["Value"]
    rows = tuple((words, *(_mesh_text(plan.get(key)) for plan in plans)) for key, words in MESH.items())
    return Table("Mesh, chosen by the accuracy asked for.", ("What", *heads), rows)


def _mesh_text(value: Any) -> str:
    """Text of a number of a mesh, of several, or of the layers and rings of its discs."""
    if isinstance(value, list):
        return ", ".join(map(str, value))
    if not isinstance(value, dict):
        return "-" if value is None else str(value)
    counts = [sum(sum(part.values()) for part in value[name]) for name in ("storeys", "annuli")]
    return f"{counts[0]} layers, {counts[1]} rings"


def _model(results: Results) -> Table:
    data = results.bands.attrs
    rows = (
        ("Unknowns of the cell", f"{int(data['unknowns']):,}".replace(",", " ")),
        ("Unknowns after condensation", str(int(data["condensed_unknowns"]))),
        ("Unknowns at every wavevector", str(int(data["basis_size"]))),
        ("Accuracy asked for", f"{float(data['accuracy']):.1g} of every frequency"),
    )
    return Table("Model.", ("What", "Value"), rows)


def _errors(results: Results) -> Table:
    data = results.bands
    frequency, error = data["frequency"].values, data["frequency_error"].values
    rows = []
    for k, band in enumerate(data["band"].values):
        worst = int(np.argmax(error[:, k]))
        relative = _largest_relative(frequency[:, k], error[:, k])
        low, high = frequency[:, k].min() / 1e3, frequency[:, k].max() / 1e3
        rows.append((f"{band}", f"{low:.2f} to {high:.2f}", f"{float(f'{error[worst, k]:.2g}'):g}", relative))
    checked, missed = int(data.attrs["counts_checked"]), int(data.attrs["counts_missed"])
    caption = (
        "Bounds of the errors along the path. "
        f"Exact counts of the modes below a frequency were compared {checked} times; modes missed: {missed}."
    )
    return Table(caption, ("Band", "Frequency (kHz)", "Largest error (Hz)", "Relative"), tuple(rows))


def _largest_relative(frequency: np.ndarray, error: np.ndarray) -> str:
    """Largest relative error of a band without rigid motions, whose frequency is zero."""
    moving = frequency > 1e-3 * frequency.max()
    return f"{(error[moving] / frequency[moving]).max():.1e}" if moving.any() else "-"


def _versions(results: Results) -> Table:
    rows = [(name, version(name)) for name in LIBRARIES]
    rows += [("Python", platform.python_version()), ("System", f"{platform.system()} {platform.machine()}")]
    attrs = results.bands.attrs
    if "code_fingerprint" in attrs:
        rows.append(("Fingerprint of the numerical code", str(attrs["code_fingerprint"])[:16]))
    return Table("Versions.", ("What", "Version"), tuple(rows))
