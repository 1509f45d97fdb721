"""Studies as users write them: all lattices, one to three sites, drafts, fillets, oblique cells, micrometres.

`study_text` draws one from a seed and a number. Most numbers of such a study are round, as people write them.
"""

from __future__ import annotations

import math
import warnings

import numpy as np

from haptonic.errors import HaptonicError, HaptonicWarning
from haptonic.study import Study, loads

LATTICES = (
    "square",
    "two sites",
    "triangular",
    "oblique",
    "honeycomb",
    "rectangular",
    "three sites",
    "vectors",
    "kagome",
    "centred",
    "lieb",
    "two sites on a triangle",
)
MATERIALS = {
    "steel": ("200 GPa", 0.29, "7850 kg/m^3"),
    "aluminium": ("70 GPa", 0.33, "2700 kg/m^3"),
    "brass": ("100 GPa", 0.34, "8500 kg/m^3"),
    "silicon, as isotropic": ("165 GPa", 0.22, "2329 kg/m^3"),
}
SITES = {"honeycomb": 2, "kagome": 3, "lieb": 3}
PITCHES = (3.0, 5.0, 6.0, 7.0, 8.0, 10.0, 12.0, 20.0)


def study_text(seed: int, number: int) -> tuple[str, str]:
    """Kind of the lattice and text of the study; studies that are no valid cell are drawn again."""
    rng = np.random.default_rng([seed, number])
    kind = LATTICES[number % len(LATTICES)]
    while True:
        text = _text(rng, kind)
        try:
            assert _read(text).cell.tiles
        except HaptonicError:
            continue
        return kind, text


def study_of(seed: int, number: int) -> Study:
    """The drawn study."""
    return _read(study_text(seed, number)[1])


def _read(text: str) -> Study:
    """The study, without warnings of unusual sizes: micrometres are meant."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", HaptonicWarning)
        return loads(text)


def _text(rng: np.random.Generator, kind: str) -> str:
    unit = "um" if rng.random() < 0.25 else "mm"
    scale = 10.0 if unit == "um" else 1.0
    pitch = float(rng.choice(PITCHES)) * scale

    def length(low: float, high: float) -> str:
        """Length between shares of the pitch, with two digits as people write it."""
        value = pitch * math.exp(rng.uniform(math.log(low), math.log(high)))
        return f'"{float(f"{value:.2g}"):g} {unit}"'

    name = str(rng.choice(list(MATERIALS)))
    modulus, ratio, density = MATERIALS[name]
    lines = [
        "[material]",
        f'name = "{name}"',
        f'youngs_modulus = "{modulus}"',
        f"poisson_ratio = {ratio}",
        f'density = "{density}"',
        "[cell]",
        f"thickness = {length(0.05, 0.4)}",
    ]
    lattice = {"two sites": "square", "three sites": "rectangular"}.get(kind, kind)
    lattice = "triangular" if "triangle" in kind else lattice
    if kind == "vectors":
        x, y = pitch * rng.integers(5) / 10, pitch * rng.integers(8, 13) / 10
        lines += [f'a1 = ["{pitch:g} {unit}", "0 {unit}"]', f'a2 = ["{x:g} {unit}", "{y:g} {unit}"]']
    else:
        lines += [f'lattice = "{lattice}"', f'pitch = "{pitch:g} {unit}"']
        if lattice in ("rectangular", "centred"):
            lines.append(f"pitch_y = {length(0.7, 1.5)}")
        if lattice == "oblique":
            lines += [f"pitch_2 = {length(0.8, 1.25)}", f'angle = "{rng.integers(12, 17) * 5} deg"']
    count = 2 if kind.startswith("two") else 3 if kind.startswith("three") else 1
    widest = {1: 0.8, 2: 0.4, 3: 0.3}[SITES.get(lattice, count)]
    if count == 1:
        return "\n".join([*lines, "[cell.pillar]", *_pillar(rng, length, widest)]) + "\n"
    for site in range(count):
        place = [0.0, 0.0] if site == 0 else (rng.integers(5, 16, 2) / 20).tolist()
        lines += ["[[cell.site]]", f"at = {place}", "[cell.site.pillar]", *_pillar(rng, length, widest)]
    return "\n".join(lines) + "\n"


def _pillar(rng: np.random.Generator, length, widest: float) -> list[str]:  # type: ignore[no-untyped-def]
    lines = [f"diameter = {length(0.25 * widest, widest)}", f"height = {length(0.15, 2.0)}"]
    if rng.random() < 0.2:
        lines.append('section = "square"')
    if rng.random() < 0.2:
        lines.append(f'draft = "{rng.integers(1, 4)} deg"')
    if rng.random() < 0.2:
        lines.append(f"fillet = {length(0.02, 0.1)}")
    return lines
