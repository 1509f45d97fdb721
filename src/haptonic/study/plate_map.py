"""Map of a plate, with a letter for each tile, and checks of it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from haptonic.errors import nearest, shown
from haptonic.fields import problem
from haptonic.plate.layout.grid import pieces

NOTHING = "."  # letter of an absent tile
MOST_TILES = 100_000
ALIKE = ("O0oQ", "1lI|i", "2zZ", "5sS", "8B")  # letters that are easily confused


def drawn(text: str, *, holes: bool = True) -> str:
    """The map without blanks at the ends of lines and without empty lines around it.

    holes : whether tiles may be absent
    """
    lines = [line.strip() for line in text.strip().splitlines()]
    if not any(set(line) - {NOTHING} for line in lines):
        raise problem(
            "malformed",
            "a map without tiles" if text.strip() else "nothing",
            "lines of letters, one letter for each tile",
            "the map is empty" if not text.strip() else "all its letters mean that there is no plate",
            'write map = """, then a line of letters for each row of tiles, then """',
        )
    for number, line in enumerate(lines, start=1):
        if len(line) != len(lines[0]):
            raise problem(
                "malformed",
                f"{len(line)} tiles in line {number}, {shown(line)}",
                f"{len(lines[0])} tiles in every line, as in the first",
                "a tile was left out or written twice" if line else "a line is empty",
                f"correct line {number}" + f'; "{NOTHING}" is an absent tile' * holes,
            )
    if len(lines) * len(lines[0]) > MOST_TILES:
        raise _too_large(len(lines), len(lines[0]))
    return "\n".join([*lines, ""])


def check_map(lines: Sequence[str], rows: int | None, tiles: Mapping[str, str]) -> None:
    """Refuse unknown letters, a number of rows that does not fit the map, and plates in several pieces."""
    if rows is not None and rows % len(lines):
        raise problem(
            "conflict",
            str(rows), f"a multiple of {len(lines)}, the lines of the map",
            "the map is repeated as a whole", f"write rows = {max(1, round(rows / len(lines))) * len(lines)}",
            at="rows",
        )  # fmt: skip
    check_letters(lines, tiles)
    if (rows or 0) * len(lines[0]) > MOST_TILES:
        raise _too_large(rows or 0, len(lines[0]), at="rows")
    whole = list(lines) * ((rows or len(lines)) // len(lines))
    _check_borders(whole)
    # the layout begins with the lowest row
    parts = pieces([[letter != NOTHING for letter in line] for line in reversed(whole)])
    if len(parts) > 1:
        row, column = min(parts[-1])
        raise problem(
            "malformed",
            f"{len(parts)} pieces: {', '.join(f'{len(part)} tiles' for part in parts)}",
            "tiles that are connected by their sides",
            f"the tile in line {len(whole) - row}, column {column + 1} belongs to a separate piece",
            f'connect the pieces by tiles, not by corners; write "{NOTHING}" for an unwanted piece',
            at="map",
        )


def check_letters(
    lines: Sequence[str], tiles: Mapping[str, str], table: str = "[plate.tiles]", *, holes: bool = True
) -> None:
    """Refuse letters that a table does not explain, and entries of it that are invalid or not used.

    holes : whether tiles may be absent
    """
    names = list(tiles.values())
    for letter, name in tiles.items():
        at = f"tiles.{letter if letter.isalnum() else shown(letter)}"
        if len(letter) != 1 or letter.isspace() or letter == NOTHING:
            raise problem(
                "malformed",
                shown(letter), f'one letter, and not "{NOTHING}"',
                "this letter always means an absent tile" if letter == NOTHING
                else "every letter of the map is one tile",
                f'choose one letter for "{name}"', at=at,
            )  # fmt: skip
        if names.count(name) > 1:
            raise problem(
                "repeated",
                f"{shown(name)}, twice", "one letter for each lattice and each region", "a line was copied",
                "choose another name, or write the same letter in the map", at=at,
            )  # fmt: skip
    for number, line in enumerate(lines, start=1):
        for column, letter in enumerate(line, start=1):
            if letter not in tiles and letter != NOTHING:
                guess = NOTHING if letter.isspace() and holes else _nearest_letter(letter, tiles)
                raise problem(
                    "unknown",
                    f"{shown(letter)} in line {number}, column {column}",
                    f"one of {', '.join(tiles)}" + f', or "{NOTHING}" where there is no plate' * holes,
                    f"{table} does not explain this letter",
                    f'write "{guess}"' if guess else f'add {letter} = "..." to {table}',
                    at="map",
                )
    used = set().union(*lines)
    for letter, name in tiles.items():
        if letter not in used:
            raise problem(
                "conflict",
                shown(name), "a name that some tile of the map has",
                f"the map does not contain the letter {shown(letter)}, so it would have no tiles",
                "write the letter in the map, or leave it out here", at=f"tiles.{letter}",
            )  # fmt: skip


def _nearest_letter(letter: str, letters: Mapping[str, str]) -> str | None:
    alike = next((group for group in ALIKE if letter in group), letter)
    taken = [each for each in letters if each in alike or each.casefold() == letter.casefold()]
    return taken[0] if taken else nearest(letter, letters)


def _check_borders(lines: Sequence[str]) -> None:
    borders = {
        "the first line": lines[0],
        "the last line": lines[-1],
        "the first column": "".join(line[0] for line in lines),
        "the last column": "".join(line[-1] for line in lines),
    }
    for name, letters in borders.items():
        if not set(letters) - {NOTHING}:
            raise problem(
                "malformed",
                f'{name}, all "{NOTHING}"', "a map with a tile in each of its border lines and columns",
                "the plate is smaller than its map", f"leave {name} out", at="map",
            )  # fmt: skip


def _too_large(rows: int, columns: int, at: str = "") -> Exception:
    return problem(
        "too-large",
        f"{rows} rows of {columns} tiles", f"at most {MOST_TILES} tiles", "the plate is far too large",
        "choose fewer rows or larger tiles", at=at,
    )  # fmt: skip
