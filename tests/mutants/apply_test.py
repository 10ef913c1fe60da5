#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Every mutant still finds the one place that it breaks, and every test that it names is there. That those notice takes an hour:
tests/mutants/run."""
import re
import sys

import mutants

GOLDENS = mutants.ROOT / "tests/golden"


def known_tests():
    """SUITE.TEST of all GoogleTests of the sources, and names of goldens."""
    tests = {path.stem for path in GOLDENS.glob("*.json")} | {"exr", "separate"}
    for path in (mutants.ROOT / "tests").glob("**/*_test.cpp"):
        tests.update(f"{suite}.{test}" for suite, test in re.findall(r"^TEST(?:_F|_P)?\((\w+), (\w+)\)", path.read_text(), re.M))
    return tests


def faults(data):
    known, names = known_tests(), [mutant["name"] for mutant in data["mutants"]]
    yield from (f"{name}: twice" for name in set(names) if names.count(name) > 1)
    yield from (f"exempt: no test is called {test}" for test in sorted(set(data["exempt"]) - known))
    for mutant in data["mutants"]:
        if fault := mutants.fault(mutant, mutants.ROOT):
            yield fault
        if mutant["replace"] == mutant["by"]:
            yield f'{mutant["name"]}: breaks nothing'
        tests = {test for suite in mutant["red"].values() for test in suite}
        yield from (f'{mutant["name"]}: no test is called {test}' for test in sorted(tests - known))


found = list(faults(mutants.load()))
print("\n".join(found) or "all mutants apply")
sys.exit(bool(found))
