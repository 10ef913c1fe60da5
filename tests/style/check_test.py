# SPDX-License-Identifier: Apache-2.0
"""The style check sees each kind of finding."""
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

CHECK = Path(__file__).with_name("check.py")
LICENCE = "// SPDX-License-Identifier: Apache-2.0\n"


def run(name, text):
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, name)
        path.parent.mkdir(parents=True)
        path.write_text(text)
        result = subprocess.run([sys.executable, str(CHECK), folder], capture_output=True, text=True, check=False)
        return result.returncode, result.stdout


class StyleCheck(unittest.TestCase):
    def test_good_files(self):
        self.assertEqual(run("common/a.cpp", LICENCE + "int a = 1;\n"), (0, ""))
        self.assertEqual(run("scripts/a", "#!/bin/sh\n# SPDX-License-Identifier: Apache-2.0\n"), (0, ""))

    def test_licence(self):
        for name in ("common/a.cpp", "shaders/a.comp", "tests/CMakeLists.txt", "tests/a.py"):
            code, output = run(name, "\n")
            self.assertEqual(code, 1)
            self.assertIn("licence line", output)
        self.assertEqual(run("scripts/a", "#!/bin/sh\nset -e\n")[0], 1)

    def test_format(self):
        code, output = run("common/a.cpp", LICENCE + "int   a=1;\n")
        self.assertEqual(code, 1)
        self.assertIn("a.cpp", output)

    def test_length(self):
        code, output = run("common/a.cpp", LICENCE + "int f();\n" * 400)
        self.assertEqual(code, 1)
        self.assertIn("401 lines", output)


if __name__ == "__main__":
    unittest.main()
