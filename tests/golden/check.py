#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""check.py BUILD NAME: bakes and renders one golden with the shipped programs and compares.
check.py BUILD --separate: every threshold must tell its golden from every other golden.
On failure the pictures stay in BUILD/golden."""
import itertools
import sys
from pathlib import Path

import golden


def separate(programs):
    names = golden.cases()
    confused = []
    for name, other in itertools.combinations(names, 2):
        figures = programs.compare(golden.stored(other), golden.stored(name))  # nearly the same the other way round
        if not all(golden.exceeded(golden.load(one), figures) for one in (name, other)):
            confused.append(f"{other} and {name} would pass as each other")
    if len(names) < 8 or confused:
        raise golden.Failure("\n".join(confused) or f"only {len(names)} goldens")


def main():
    build, what = sys.argv[1:]
    programs = golden.Programs(build, Path(build) / "golden")
    try:
        separate(programs) if what == "--separate" else golden.check(programs, what)
    except golden.Failure as failure:
        print(failure)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
