# SPDX-License-Identifier: Apache-2.0
"""The layering check sees each kind of violation: one small tree per kind."""
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

CHECK = Path(__file__).with_name("check.py")


def run(files, *options):
    with tempfile.TemporaryDirectory() as folder:
        for name, text in files.items():
            path = Path(folder, name)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
        command = [sys.executable, str(CHECK), folder, *(option.format(folder=folder) for option in options)]
        result = subprocess.run(command, capture_output=True, text=True, check=False)
        return result.returncode, result.stdout


def compile_library(folder, text):
    source = Path(folder, "a.cpp")
    source.write_text(text)
    subprocess.run(["c++", "-c", str(source), "-o", str(source.with_suffix(".o"))], check=True)
    library = Path(folder, "a.a")
    subprocess.run(["ar", "rc", str(library), str(source.with_suffix(".o"))], check=True)
    return library


class LayeringCheck(unittest.TestCase):
    def accept(self, folder, include):
        self.assertEqual(run({f"{folder}/a.cpp": f"#include {include}\n"}), (0, ""))

    def refuse(self, folder, include):
        code, output = run({f"{folder}/a.cpp": f"#include {include}\n"})
        self.assertEqual(code, 1)
        self.assertIn(f"{folder}/a.cpp", output)

    def test_arrows_downwards(self):
        self.accept("bake/commands", '"bake/kernels/a.h"')
        self.accept("bake/kernels", '"common/light/box.h"')
        self.accept("runtime/app", '"runtime/light/a.h"')
        self.accept("common/base", "<vector>")

    def test_arrows_upwards(self):
        self.refuse("bake/scene", '"bake/transport/a.h"')
        self.refuse("bake/transport", '"bake/kernels/a.h"')
        self.refuse("bake/kernels", '"bake/commands/a.h"')
        self.refuse("runtime/vulkan", '"runtime/kernels/a.h"')
        self.refuse("runtime/light", '"runtime/app/a.h"')

    def test_wings_apart(self):
        self.refuse("bake/scene", '"runtime/light/a.h"')
        self.refuse("runtime/app", '"bake/scene/scene.h"')
        self.refuse("common/light", '"bake/scene/scene.h"')
        self.refuse("common/light", '"runtime/light/a.h"')

    def test_libraries_kept_out(self):
        self.refuse("common/base", "<embree3/rtcore.h>")
        self.refuse("common/base", "<vulkan/vulkan_raii.hpp>")
        self.refuse("bake/scene", "<vulkan/vulkan.hpp>")
        self.refuse("runtime/app", "<embree3/rtcore.h>")

    def test_unknown_folder_and_bare_name(self):
        self.refuse("common/attic", "<vector>")
        self.refuse("common/base", '"error.h"')

    def test_links(self):
        with tempfile.TemporaryDirectory() as folder:
            library = compile_library(folder, 'extern "C" void rtcCommitScene(void*);\nvoid f() { rtcCommitScene(nullptr); }\n')
            code, output = run({}, "--common", str(library))
            self.assertEqual(code, 1)
            self.assertIn("rtcCommitScene", output)
            library = compile_library(folder, "int f() { return 1; }\n")
            self.assertEqual(run({}, "--common", str(library))[0], 0)
            self.assertEqual(run({}, "--common", str(library), "--common-links", "glm::glm;Vulkan::Vulkan")[0], 1)

    def test_needs(self):
        self.assertEqual(run({}, "--needs", f"{sys.executable}=libc\\.so")[0], 1)
        self.assertEqual(run({}, "--needs", f"{sys.executable}=libembree")[0], 0)


if __name__ == "__main__":
    unittest.main()
