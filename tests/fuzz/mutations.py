"""Damage that files suffer or that somebody does to them, drawn with a seed."""

from __future__ import annotations

import re

import numpy as np

WORDS = (
    b"nan", b"inf", b"-inf", b"-1", b"0", b"1e999", b"1D+400", b"9999999999", b"-2147483649", b"4294967296",
    b"1e308", b"1\xc2\xb2", b"\xff\xfe", b"", b"=2+5", b"\0", b"\xe9", b"x" * 300, b"\x1b[31m", b"[/x]",
    b"../../x", b"9" * 5000,
)  # fmt: skip
BYTES = (0, 1, 2, 7, 127, 128, 129, 254, 255)
HEAD = 4096  # bytes; the description of a file is mostly there


def _place(chance: np.random.Generator, content: bytes) -> int:
    """Anywhere, or one time of two near the beginning."""
    return int(chance.integers(min(len(content), HEAD) if chance.random() < 0.5 else len(content)))


def _set_byte(chance, content):
    at = _place(chance, content)
    value = int(chance.choice(BYTES)) if chance.random() < 0.5 else int(chance.integers(256))
    return content[:at] + bytes([value]) + content[at + 1 :]


def _flip_bit(chance, content):
    at = _place(chance, content)
    return content[:at] + bytes([content[at] ^ 1 << int(chance.integers(8))]) + content[at + 1 :]


def _cut(chance, content):
    return content[: _place(chance, content)]


def _lose(chance, content):
    at = _place(chance, content)
    return content[:at] + content[at + int(chance.integers(1, 64)) :]


def _repeat(chance, content):
    at = _place(chance, content)
    part = content[at : at + int(chance.integers(1, 512))]
    return content[:at] + part * int(chance.integers(2, 5)) + content[at + len(part) :]


def _zeros(chance, content):
    at = _place(chance, content)
    length = min(int(chance.integers(1, 256)), len(content) - at)
    return content[:at] + bytes(length) + content[at + length :]


def _number(chance, content):
    """A whole number of 2, 4 or 8 bytes, made huge, negative or odd."""
    width = int(chance.choice([2, 4, 8]))
    at = _place(chance, content) // width * width
    value = int(chance.choice([0, 1, 2**7, 2**15 - 1, 2**16 - 1, 2**31 - 1, 2**32 - 1, 2**40, 2**63 - 1]))
    return content[:at] + (value % 256**width).to_bytes(width, "little") + content[at + width :]


def _moved(chance, content):
    """A part of the file over another part of it."""
    here, there = _place(chance, content), _place(chance, content)
    length = int(chance.integers(1, 128))
    return content[:there] + content[here : here + length] + content[there + length :]


def _word(chance, content):
    """A word of a text, or what looks like one in bytes, exchanged."""
    at = _place(chance, content)
    match = re.search(rb"[^\s,;]+", content[at : at + 400])
    if match is None:
        return _set_byte(chance, content)
    word = WORDS[int(chance.integers(len(WORDS)))]
    return content[: at + match.start()] + word + content[at + match.end() :]


def _line(chance, content):
    """A line lost, doubled or put elsewhere."""
    lines = content.splitlines(keepends=True)
    at = int(chance.integers(len(lines)))
    line = [lines.pop(at)] * int(chance.integers(3))
    there = int(chance.integers(len(lines) + 1)) if chance.random() < 0.5 else at
    return b"".join(lines[:there] + line + lines[there:])


ANY = (_set_byte, _flip_bit, _cut, _lose, _repeat, _zeros, _number, _moved, _word)
TEXT = (*ANY, _word, _word, _line, _line)


def mutated(content: bytes, chance: np.random.Generator, *, text: bool) -> bytes:
    """The content with one to four faults."""
    for _ in range(int(chance.choice([1, 1, 1, 2, 4]))):
        if content:
            kinds = TEXT if text else ANY
            content = kinds[int(chance.integers(len(kinds)))](chance, content)
    return content
