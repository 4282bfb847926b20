"""Runs random programs against their models: the command line that such tests share."""
import argparse
import pathlib
import tempfile

from budget import budgeted


def run(doc, program_of, difference, suffix, kinds=("",), programs=40, before=None):
    """Each seed makes a program of each kind. `program_of(seed)`, or `program_of(seed, kind)` where there are kinds, has
    its lines in `lines`; `difference(isogloss, folder, program)` gives how many moves were equal, and what differs or
    None. `before(isogloss, folder)` runs once and gives what differs or None. The exit status: 1 where a program
    differs, or none was compared."""
    parser = argparse.ArgumentParser(description=doc, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--isogloss", required=True, type=pathlib.Path)
    parser.add_argument("--programs", type=int, default=budgeted(programs), help="how many, each a program of each kind")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--keep", type=pathlib.Path, help="write programs that differ there")
    options = parser.parse_args()
    isogloss = options.isogloss.resolve()
    compared = differing = 0
    with tempfile.TemporaryDirectory(prefix="isogloss-random-") as name:
        folder = pathlib.Path(name)
        report = before(isogloss, folder) if before else None
        if report:
            differing += 1
            print(f"before the programs: {report}")
        for seed in range(options.seed, options.seed + options.programs):
            for kind in kinds:
                program = program_of(seed, kind) if kind else program_of(seed)
                count, report = difference(isogloss, folder, program)
                compared += count
                if report is None:
                    continue
                differing += 1
                print(f"seed {seed}{', ' + kind if kind else ''}: after {count} equal moves: {report}")
                if options.keep:
                    options.keep.mkdir(parents=True, exist_ok=True)
                    (options.keep / f"{kind}{seed}{suffix}").write_text("\n".join(program.lines) + "\n")
    print(f"{len(kinds) * options.programs} programs, {compared} moves compared, {differing} programs differ")
    return 1 if differing or compared == 0 else 0
