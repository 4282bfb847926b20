"""The workload surface in other languages: the same moves, as posts for these controls write them."""
import re

MOVE = re.compile(r"(?:G1 )?([XYZ]\S+(?: [XYZ]\S+)*)(?: F(\d+))?$")


def moves(program):
    """(words, feed or None) of each feed move."""
    for line in program.splitlines():
        if found := MOVE.match(line):
            yield found[1], found[2]


def siemens(program):
    head = ["G71 G17 G90 G94 G40", "T4 M6", "G54", "S7800 M3", "G0 X0 Y0", "Z50 M8"]
    body = [("G1 " if number == 0 else "") + words + (f" F{feed}" if feed else "")
            for number, (words, feed) in enumerate(moves(program))]
    return "\n".join([*head, *body, "M9", "M5", "M30"]) + "\n"


def klartext(program):
    head = ["BEGIN PGM SURFACE MM", "TOOL CALL 4 Z S7800", "L X+0 Y+0 R0 FMAX M3", "L Z+50 R0 FMAX M8"]
    body = ["L " + re.sub(r"([XYZ])(?=\d)", r"\1+", words).replace(". ", " ").rstrip(".") + (f" F{feed}" if feed else "")
            for words, feed in moves(program)]
    blocks = [*head, *body, "L M5", "L M30", "END PGM SURFACE MM"]
    return "\n".join(f"{number} {block}" for number, block in enumerate(blocks)) + "\n"
