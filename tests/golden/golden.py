# SPDX-License-Identifier: Apache-2.0
"""One golden: NAME.json says how the picture is made and how far it may move, NAME.exr (or .png) is the picture.

JSON: "about"; "scene": name and "set" of boxlight_data; "bake": options of ptbake bake; "environment": of boxlight_data;
"view": options of ptview; "format": ".png" for a display picture, else linear; "exposure": of the PNGs on the update page; "mesa": the driver that made the picture;
"thresholds": the most that `ptbake compare --json` may say of each named figure.
"""
import json
import subprocess
from pathlib import Path

import exr

FOLDER = Path(__file__).parent
VIEW_ALWAYS = ["--headless", "--validation", "--device", "llvmpipe", "--background", "off", "--size", "96x96"]


class Failure(Exception):
    """What the test says when it is red."""


def cases():
    return sorted(path.stem for path in FOLDER.glob("*.json"))


def load(name):
    return json.loads((FOLDER / f"{name}.json").read_text())


def suffix(name):
    """Of a golden: what the picture is written as."""
    return load(name).get("format", ".exr")


def stored(name):
    return FOLDER / f"{name}{suffix(name)}"


class Programs:
    """The built programs, and the folder below the build folder where pictures go."""

    def __init__(self, build, work):
        self.bin, self.work = Path(build) / "bin", Path(work)
        self.work.mkdir(parents=True, exist_ok=True)

    def run(self, program, *arguments, accept=(0,)):
        command = [str(self.bin / program), *map(str, arguments)]
        result = subprocess.run(command, capture_output=True, text=True, check=False)
        if result.returncode not in accept:
            raise Failure(f"{' '.join(command)}\nended with {result.returncode}: {result.stderr.strip()}")
        return result.stdout

    def render(self, name):
        """Scene, bake, picture: returns the path of the picture in the work folder."""
        case = load(name)
        scene, asset, light = (self.work / f"{name}{suffix}" for suffix in (".glb", ".ptb", "-light.exr"))
        picture = self.work / f"{name}{suffix(name)}"
        settings = [word for item in case["scene"].get("set", {}).items() for word in ("--set", "{}={}".format(*item))]
        self.run("boxlight_data", "scene", case["scene"]["name"], scene, *settings)
        self.run("boxlight_data", "environment", case["environment"], light)
        self.run("ptbake", "bake", scene, "-o", asset, "--quiet", *case["bake"].split())
        self.run("ptview", asset, "--env", light, "-o", picture, "--quiet", *VIEW_ALWAYS, *case["view"].split())
        return picture

    def compare(self, picture, reference, *options):
        return json.loads(self.run("ptbake", "compare", picture, reference, "--json", *options))

    def mesa(self):
        devices = json.loads(self.run("ptview", "--list-devices", "--json"))
        return next(device["driver"] for device in devices if "llvmpipe" in device["name"])


def exceeded(case, figures):
    """The figures above their thresholds, in words."""
    return [f"{name} {figures[name]:.4g} is above {limit:g}" for name, limit in case["thresholds"].items() if figures[name] > limit]


def check(programs, name):
    case, golden = load(name), stored(name)
    if not golden.exists():
        raise Failure(f"there is no {golden.name} yet: run tests/golden/update and look at its page")
    picture = programs.render(name)
    difference = programs.work / f"{name}-difference.png"
    found = exceeded(case, programs.compare(picture, golden, "--diff", difference))
    if found:
        if suffix(name) == ".exr":
            exr.write_png(programs.work / f"{name}.png", exr.read(picture), case.get("exposure", 0))
        mesa = programs.mesa()
        note = "" if mesa == case["mesa"] else f"\nthe golden was made with {case['mesa']}, this is {mesa}"
        raise Failure(f"{'; '.join(found)}\nsee {difference}{note}")
