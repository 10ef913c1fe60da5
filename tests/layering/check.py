#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Holds the building to its plan: which folder may include which, and which library may need which.

check.py SOURCE [--common LIB.a] [--common-links NAMES] [--needs PROGRAM=FORBIDDEN]...
Prints one line per violation and ends with 1 if there is any.
"""
import argparse
import re
import subprocess
import sys
from pathlib import Path

# What each folder may include beside itself; the four of common are one library. "spirv" are the compiled shaders, made
# in the build folder. A folder that is not named here is a violation: add it where it belongs.
RUNTIME_BELOW = ["common", "shaders", "spirv"]
MAY_INCLUDE = {
    "common/base": [],
    "common/light": ["common"],
    "common/image": ["common"],
    "common/asset": ["common"],
    "bake/scene": ["common"],
    "bake/transport": ["common", "bake/scene"],
    "bake/kernels": ["common", "bake/scene", "bake/transport"],
    "bake/study": ["common", "bake/scene", "bake/transport", "bake/kernels"],
    "bake/commands": ["common", "bake/scene", "bake/transport", "bake/kernels", "bake/study"],
    "bake": ["common", "bake/commands"],
    "runtime/vulkan": RUNTIME_BELOW,
    "runtime/light": RUNTIME_BELOW + ["runtime/vulkan"],
    "runtime/kernels": RUNTIME_BELOW + ["runtime/vulkan"],
    "runtime/app": RUNTIME_BELOW + ["runtime/vulkan", "runtime/light", "runtime/kernels"],
    "runtime": ["common", "runtime/app"],
    "shaders": ["common/base"],
    "data": ["common"],
}
SYSTEM_FORBIDDEN = {
    "common": r"embree|vulkan|tbb/|tiny_gltf|Eigen",
    "bake": r"vulkan|GLFW|imgui",
    "runtime": r"embree|tiny_gltf|Eigen",
}
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.MULTILINE)


def is_inside(folder, ancestor):
    return folder == ancestor or folder.startswith(ancestor + "/")


def include_violations(source):
    for top in ("common", "bake", "runtime", "shaders", "data"):
        for path in sorted((source / top).rglob("*")):
            if path.suffix not in {".cpp", ".h", ".hpp"}:
                continue
            folder = path.parent.relative_to(source).as_posix()
            if folder not in MAY_INCLUDE:
                yield f"{path.relative_to(source)}: folder {folder} has no place in tests/layering/check.py"
                continue
            for bracket, target in INCLUDE.findall(path.read_text()):
                problem = system_problem(folder, target) if bracket == "<" else project_problem(folder, target)
                if problem:
                    yield f"{path.relative_to(source)}: includes {target}: {problem}"


def system_problem(folder, target):
    for top, pattern in SYSTEM_FORBIDDEN.items():
        if is_inside(folder, top) and re.search(pattern, target, re.IGNORECASE):
            return f"{top} does without it"
    return None


def project_problem(folder, target):
    if "/" not in target:
        return "say the path from the repository's root"
    other = target.rsplit("/", 1)[0]
    if other == folder or any(is_inside(other, allowed) for allowed in MAY_INCLUDE[folder]):
        return None
    return f"{folder} may include only {', '.join(MAY_INCLUDE[folder]) or 'itself'}"


def undefined_symbols(library):
    output = subprocess.run(["nm", "--undefined-only", "--format=posix", library], check=True, capture_output=True, text=True)
    return {line.split()[0] for line in output.stdout.splitlines() if line and not line.endswith(":")}


def link_violations(library, links):
    for symbol in sorted(undefined_symbols(library)):
        if re.match(r"rtc[A-Z]|vk[A-Z]", symbol):
            yield f"{library}: needs {symbol}"
    for name in links.split(";"):
        if re.search(r"embree|vulkan|tbb|tinygltf", name, re.IGNORECASE):
            yield f"boxlight_common: links {name}"


def need_violations(program, forbidden):
    output = subprocess.run(["readelf", "--dynamic", "--wide", program], check=True, capture_output=True, text=True)
    for name in re.findall(r"\(NEEDED\).*\[(.+)\]", output.stdout):
        if re.search(forbidden, name, re.IGNORECASE):
            yield f"{program}: needs {name}"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("source", type=Path)
    parser.add_argument("--common")
    parser.add_argument("--common-links", default="")
    parser.add_argument("--needs", action="append", default=[], metavar="PROGRAM=FORBIDDEN")
    options = parser.parse_args()
    violations = list(include_violations(options.source))
    if options.common:
        violations += link_violations(options.common, options.common_links)
    for need in options.needs:
        violations += need_violations(*need.split("=", 1))
    for violation in violations:
        print(violation)
    return 1 if violations else 0


if __name__ == "__main__":
    sys.exit(main())
