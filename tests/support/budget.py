"""How many cases a random test runs: its own number, times what `./dev test --full` asks for."""
import os


def budgeted(cases):
    return cases * int(os.environ.get("ISOGLOSS_TEST_BUDGET", "1"))
