"""Writes all mutants of a source into it at once: each place asks which mutant was chosen for the process."""


def rendered(source, mutants):
    """`mutants`: (number, mutant) of this source. Lines stay where they are, so that a compiler's complaint names them."""
    places = {}
    for number, mutant in mutants:
        places.setdefault((mutant.start, mutant.end), []).append((number, mutant))
    # Outer places before inner ones; two places are disjoint, or one holds the other.
    order = sorted(places, key=lambda place: (place[0], -place[1]))
    out, position = _inside(source, 0, len(source), order, 0, places)
    if position != len(order):
        raise ValueError(f"the place {order[position]} lies in no other, nor beside it")
    return out


def _inside(source, start, end, order, position, places):
    out, at = [], start
    while position < len(order) and order[position][1] <= end:
        first, last = order[position]
        if first < at:
            raise ValueError(f"the place {first}, {last} overlaps another")
        out.append(source[at:first])
        text, position_after = _inside(source, first, last, order, position + 1, places)
        out.append(_choices(source[first:last], text, places[first, last]))
        at, position = last, position_after
    out.append(source[at:end])
    return "".join(out), position


def _choices(pristine, text, mutants):
    """The text with its own mutants around it: of the value first, of the statement last."""
    pristine = pristine.replace("\n", " ")
    values = "".join(f"isogloss_mutants::is({n}) ? ({m.text.replace(chr(10), ' ')}) : " for n, m in mutants
                     if m.form == "value")
    if values:
        text = f"({values}({text}))"
    for number, mutant in mutants:
        if mutant.form == "condition":
            text = f"(isogloss_mutants::is({number}) ? !({pristine}) : static_cast<bool>({text}))"
    for number, mutant in mutants:
        if mutant.form == "statement":
            text = f"(isogloss_mutants::is({number}) ? void() : static_cast<void>({text}))"
    return text
