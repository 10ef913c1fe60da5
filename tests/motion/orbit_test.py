#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""orbit_test.py BUILD: a slow orbit around a sharp mirror. Its pictures have to change from frame to frame as the truth's do: reflections
that fade from view to view, or pop, do not."""
import math
import subprocess
import sys
from pathlib import Path

sys.dont_write_bytecode = True
TESTS = Path(__file__).resolve().parent.parent
sys.path[:0] = [str(TESTS / "golden"), str(TESTS / "motion")]
import exr  # noqa: E402
import motion  # noqa: E402

SCENE, LIGHT, BAKE = "material_sharp_metal", "gallery", "--atlas 64 --paths 32"
FRAMES, STEP, TRUTH_PATHS = 6, 1.5, 256
# Measured: error .67, steps 1.04 to 1.21 of the truth's (the plate that the mirror shows, and noise of few paths). With --scheme sketch:
# .97, 1.31 to 1.46.
MOST_ERROR, LEAST_STEP, LARGEST_STEP = 0.75, 0.95, 1.3


def camera(degrees):
    angle, away, height = math.radians(degrees), 0.287, 0.19
    eye = f"{away * math.sin(angle):.5f},{height},{away * math.cos(angle):.5f}"
    return ["--eye", eye, "--target", "0,0.038,0", "--fov", "24", "--size", "96x96", "--background", "off"]


def main(build, *bake_options):
    work = Path(build) / "motion"
    work.mkdir(parents=True, exist_ok=True)
    scene, light, asset = work / "scene.glb", work / "light.exr", work / "asset.ptb"

    def run(program, *arguments):
        subprocess.run([str(Path(build) / "bin" / program), *map(str, arguments)], check=True, stdout=subprocess.DEVNULL)

    def frames(name, program, *arguments):
        pictures = []
        for i in range(FRAMES):
            file = work / f"{name}-{i}.exr"
            run(program, *arguments, "--env", light, "-o", file, "--quiet", *camera(35 + STEP * i))
            pictures.append(exr.read(file))
        return pictures

    run("boxlight_data", "scene", SCENE, scene)
    run("boxlight_data", "environment", LIGHT, light)
    run("ptbake", "bake", scene, "-o", asset, "--quiet", *BAKE.split(), *bake_options)
    seen = frames("seen", "ptview", asset, "--headless", "--device", "llvmpipe")
    truths, others = (frames(f"truth{seed}", "ptbake", "render", scene, "--spp", TRUTH_PATHS, "--seed", seed) for seed in (1, 2))
    found = motion.summary(motion.steps(seen, truths, others))
    print(found)
    wrong = [
        f"{name} is {found[name]:.3f}, not within {low} and {high}"
        for name, low, high in (("error", 0, MOST_ERROR), ("least", LEAST_STEP, 2), ("largest", 0, LARGEST_STEP))
        if not low <= found[name] <= high
    ]
    print("\n".join(wrong), file=sys.stderr)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
