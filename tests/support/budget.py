"""How many cases a test runs: its own number, times ISOGLOSS_TEST_BUDGET. `./dev test --random` asks for more, the sanitizers
of `./dev test`, under which each process takes several times as long, for less."""
import os

FACTOR = float(os.environ.get("ISOGLOSS_TEST_BUDGET", "1"))


def budgeted(cases):
    return max(1, round(cases * FACTOR))


def sampled(cases):
    """Of a list that does not grow with the budget: all, or as large a part as the budget allows, from end to end."""
    cases = list(cases)
    wanted = min(len(cases), budgeted(len(cases)))
    return [cases[i * len(cases) // wanted] for i in range(wanted)] if cases else []
