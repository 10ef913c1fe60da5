# SPDX-License-Identifier: Apache-2.0
"""mutants.json: formulas broken on purpose and the tests that must notice.

"covers": suites and which of their tests some mutant must turn red ("*": all); "exempt": those that none can, and why.
"mutants": "name"; "breaks", in words; in "file" (of the repository) "replace" stands once and becomes "by"; "red": by suite, the
tests (GoogleTest: of a parametrised one at least one instance) that must fail.
"""
import json
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent


def load():
    return json.loads((Path(__file__).parent / "mutants.json").read_text())


def fault(mutant, source):
    """Why `mutant` cannot be applied to the sources below `source`, or None."""
    file = source / mutant["file"]
    count = file.read_text().count(mutant["replace"]) if file.is_file() else 0
    return None if count == 1 else f'{mutant["name"]}: {mutant["file"]} has {count} places like "{mutant["replace"]}", not 1'
