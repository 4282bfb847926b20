"""Compares the events of drilling cycles along the tool axis with their model, which the tests of two brands share."""


def expected(steps, start):
    """(event, value, feed per minute) of the steps (what, value, feed) of a model: dwells of no time and moves to where
    the tool stands are left out. `start` is where it stands at first."""
    out, level = [], start
    for what, value, feed in steps:
        if what == "dwell":
            if value > 0:
                out.append((what, float(value), None))
        elif value != level:
            level = value
            out.append((what, float(value), None if feed is None else float(feed)))
    return out


def same(a, b):
    def close(x, y):
        return x is None and y is None or x is not None and y is not None and abs(x - y) < 1e-6
    return len(a) == len(b) and all(x[0] == y[0] and close(x[1], y[1]) and close(x[2], y[2]) for x, y in zip(a, b))
