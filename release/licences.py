"""Print, as Markdown, the licence of every package that is installed beside this Python, with its text."""

from __future__ import annotations

from importlib.metadata import Distribution, distributions

TEXTS = ("LICENSE", "LICENCE", "COPYING", "NOTICE")


def licence(package: Distribution) -> str:
    """As the package states it: an SPDX expression, else its classifiers, else a word of its own."""
    told = package.metadata
    classifiers = [
        one.split(" :: ")[-1] for one in told.get_all("Classifier", []) if one.startswith("License")
    ]
    own = (told.get("License") or "").strip().splitlines()
    return told.get("License-Expression") or ", ".join(classifiers) or (own[0] if own else "not stated")


def texts(package: Distribution) -> list[str]:
    """Licence texts that came with the package."""
    files = [one for one in package.files or [] if one.name.upper().startswith(TEXTS)]
    found = [one.locate() for one in files]
    return [path.read_text("utf-8", errors="replace").strip() for path in found if path.is_file()]


packages = sorted(distributions(), key=lambda one: one.metadata["Name"].lower())
print("# Licences of what an installation brings\n\n| package | version | licence |\n|---|---|---|")
for one in packages:
    print(f"| {one.metadata['Name']} | {one.version} | {licence(one)} |")
for one in packages:
    print(f"\n## {one.metadata['Name']} {one.version}")
    for text in texts(one):
        print(f"\n````text\n{text}\n````")
