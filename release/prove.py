"""Try the built wheel as a user would, in a clean environment of every Python of this machine.

    python release/prove.py DIST

In each environment all templates are written and planned, a lattice's bands are computed, and once more after
MKL's Pardiso was taken away. The environment of the newest Python then says what was installed: licences.md
and the bill of materials (CycloneDX) beside the wheel. A command that fails ends the trial.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

OLDEST = (3, 11)
AGREE = 1e-4  # relative, of a gap with the two solvers
PARDISO = ("pypardiso", "mkl")


def main(dist: Path) -> None:
    """Try the only wheel of the folder."""
    (wheel,) = dist.glob("*.whl")
    found = pythons()
    for version, python in found.items():
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            environment = folder / "environment"
            output_of("uv", "venv", "--quiet", "--python", python, str(environment))
            installed = environment / "bin" / "python"
            output_of(
                "uv", "pip", "install", "--quiet", "--python", str(installed), f"{wheel.absolute()}[fast]"
            )
            print(f"Python {'.'.join(map(str, version))}: {tried(environment / 'bin' / 'haptonic', folder)}")
            if version == max(found):
                licences = output_of(str(installed), str(Path(__file__).with_name("licences.py").absolute()))
                (dist / "licences.md").write_text(licences, "utf-8")
                output_of("cyclonedx-py", "environment", "--output-reproducible", "--of", "JSON",
                     "-o", str(dist / "materials.cdx.json"), str(installed))  # fmt: skip
            output_of("uv", "pip", "uninstall", "--quiet", "--python", str(installed), *PARDISO)
            print(f"  without Pardiso: {tried(environment / 'bin' / 'haptonic', folder)}")


def pythons() -> dict[tuple[int, int], str]:
    """A Python of every version from the oldest on that is installed here, by (major, minor); pyenv's too."""
    more = [str(folder) for folder in Path.home().glob(".pyenv/versions/*/bin")]
    search = {"PATH": os.pathsep.join([str(Path(sys.executable).parent), *more, os.environ["PATH"]])}
    command = ("uv", "python", "list", "--only-installed", "--output-format", "json")
    # a shim of pyenv only points to a Python that is chosen elsewhere
    listed = [one for one in json.loads(output_of(*command, more=search)) if "shims" not in one["path"]]
    found = {(one["version_parts"]["major"], one["version_parts"]["minor"]): one["path"] for one in listed}
    return {version: path for version, path in sorted(found.items()) if version >= OLDEST}


def tried(haptonic: Path, folder: Path) -> str:
    """What a user does first, and in a sentence what came of it."""
    work = Path(tempfile.mkdtemp(dir=folder))
    environment = {"HAPTONIC_STORE": str(work / "store")}

    def run(*words: str) -> str:
        return output_of(str(haptonic), *words, cwd=work, more=environment)

    templates = [line.split()[0] for line in run("new").splitlines() if line[:1].isalpha() and "  " in line]
    for template in templates:
        run("new", template, f"{template}.toml")
        run("plan", f"{template}.toml")
    json.loads(run("schema"))
    machine = json.loads(run("doctor", "--json"))
    assert machine["healthy"], machine
    start = time.perf_counter()
    gap, *_ = json.loads(run("bands", "bare-cell.toml", "--json", "--out", "bands"))["gaps"]
    taken = time.perf_counter() - start
    assert (work / "bands" / "dispersion.png").stat().st_size > 0
    edges = [gap["lower_hz"], gap["upper_hz"]]
    known = folder / "edges.json"
    before = json.loads(known.read_text()) if known.exists() else edges
    known.write_text(json.dumps(edges))
    assert all(abs(one / other - 1) < AGREE for one, other in zip(edges, before, strict=True)), (
        edges,
        before,
    )
    return f"{len(templates)} templates; {machine['solver']}; bands in {taken:.0f} s"


def output_of(*command: str, cwd: Path | None = None, more: dict[str, str] | None = None) -> str:
    """Output of a command, with the programs beside this Python first on the path."""
    path = os.pathsep.join([str(Path(sys.executable).parent), os.environ["PATH"]])
    clean = {name: value for name, value in os.environ.items() if not name.startswith(("PYTHON", "HAPTONIC"))}
    ran = subprocess.run(
        command, capture_output=True, text=True, cwd=cwd, env=clean | {"PATH": path} | (more or {})
    )
    if ran.returncode:
        raise SystemExit(f"{' '.join(command)}\n{ran.stdout}{ran.stderr}")
    return ran.stdout


main(Path(sys.argv[1]))
