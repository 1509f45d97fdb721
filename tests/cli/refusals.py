"""How a command says no."""

PARTS = ("argument", "given", "allowed", "likely cause", "next step")


def assert_five_parts(ran, *words: str) -> None:
    assert ran.code == 2, ran.err
    assert "Traceback" not in ran.err + ran.out
    for part in PARTS:
        assert part in ran.err, (part, ran.err)
    for word in words:
        assert word in ran.err, (word, ran.err)
