#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""window_test.py BIN WORK: the window of the shipped ptview, by real events on a real X server; its pictures are those of
--headless with the settings that the window saves."""
import math
import os
import shutil
import subprocess
import sys
import time
import unittest
from pathlib import Path

import pictures
import viewer
import x11

BIN, WORK = Path(sys.argv[1]), Path(sys.argv[2])
SIZE = (192, 144)


def run(program, *arguments):
    result = subprocess.run([str(BIN / program), *map(str, arguments)], capture_output=True, text=True, check=False)
    if result.returncode:
        raise AssertionError(f"{program} {arguments}: {result.returncode}: {result.stderr}")


def angle(camera):
    """Of the camera around its target, degrees about +Y, and above it."""
    x, y, z = (e - t for e, t in zip(camera["eye"], camera["target"]))
    return math.degrees(math.atan2(x, z)), math.degrees(math.atan2(y, math.hypot(x, z)))


def distance(camera):
    return math.dist(camera["eye"], camera["target"])


class WindowTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        shutil.rmtree(WORK / "data", ignore_errors=True)
        (WORK / "data").mkdir(parents=True)
        cls.scene, cls.asset, cls.other = (WORK / "data" / name for name in ("ball.glb", "ball.ptb", "other.ptb"))
        cls.sky, cls.studio = WORK / "data" / "sky.exr", WORK / "data" / "studio light.exr"
        run("boxlight_data", "scene", "sphere_on_ground", cls.scene, "--set", "metallic=1")
        run("ptbake", "bake", cls.scene, "-o", cls.asset, "--atlas", 24, "--paths", 16, "--quiet")
        run("boxlight_data", "scene", "bowl", WORK / "data" / "bowl.glb")
        run("ptbake", "bake", WORK / "data" / "bowl.glb", "-o", cls.other, "--atlas", 16, "--paths", 16, "--quiet")
        run("boxlight_data", "environment", "sky", cls.sky)
        run("boxlight_data", "environment", "studio", cls.studio)
        cls.server = viewer.XServer()
        cls.addClassCleanup(cls.server.close)

    def setUp(self):
        self.captures = WORK / self._testMethodName
        shutil.rmtree(self.captures, ignore_errors=True)
        self.captures.mkdir(parents=True)
        self.screen = x11.Screen(self.server.name)
        self.addCleanup(self.screen.close)

    def start(self, *arguments, size=SIZE, asset=None):
        view = viewer.Viewer(BIN / "ptview", self.server.name, self.captures, asset or self.asset, "--env", self.sky, "--size",
                             f"{size[0]}x{size[1]}", *arguments)
        self.addCleanup(view.kill)
        view.key("Tab")  # the panel would be in the picture
        return view

    def end(self, view):
        self.assertEqual(view.quit(), 0, "".join(view.log))

    def headless(self, settings, name="headless.png"):
        path = self.captures / name
        run("ptview", "--headless", "--settings", settings, "-o", path, "--device", "llvmpipe", "--quiet")
        return path

    def shows(self, view, reference, size=SIZE, tolerance=1):
        """Waits until the window shows the picture. Rounding of the encoding may differ by a step."""
        end, last = time.monotonic() + viewer.PATIENCE, None
        while time.monotonic() < end:
            last = pictures.difference(self.screen.capture(view.window, *size), reference)
            if last[0] <= tolerance:
                return
            time.sleep(0.2)
        self.fail(f"the window shows another picture: {last[0]} steps at most, {last[1]:.3f} in the mean")

    def saved_file(self):
        return max(self.captures.glob("*.json"), key=lambda path: path.stat().st_mtime_ns)

    def shows_what_it_saves(self, view, size=SIZE):
        settings = view.settings()
        view.key("Escape")  # takes the message away
        self.shows(view, pictures.read_png(self.headless(self.saved_file())), size)
        return settings

    def test_shows_what_headless_writes(self):
        view = self.start()
        settings = self.shows_what_it_saves(view)
        self.assertEqual(settings["camera"]["size"], list(SIZE))
        self.assertEqual(settings["asset"], str(self.asset))
        self.end(view)

    def test_mouse_moves_the_camera(self):
        view = self.start()
        first = view.settings()["camera"]
        view.drag(-36, 0)  # a quarter of the height: 45 degrees
        turned = self.shows_what_it_saves(view)["camera"]
        self.assertAlmostEqual((angle(turned)[0] - angle(first)[0]) % 360, 45, delta=1)
        self.assertAlmostEqual(distance(turned), distance(first), places=4)
        view.drag(0, 1000 // 8 * 4)  # far past the pole
        self.assertAlmostEqual(angle(view.settings()["camera"])[1], 89, delta=0.1)
        view.key("r")
        self.assertEqual(view.settings()["camera"], first)
        for modifier, button in ((None, 3), (None, 2), ("shift", 1)):
            view.drag(16, -16, button, modifier)
            panned = view.settings()["camera"]
            self.assertAlmostEqual(distance(panned), distance(first), places=4)
            self.assertGreater(math.dist(panned["target"], first["target"]), 0.01)
            view.key("r")
        view.xdotool("mousemove", "--window", view.window, 100, 60, "click", 4, "sleep", 0.1)
        self.assertAlmostEqual(distance(view.settings()["camera"]), distance(first) / 1.1, places=4)
        view.key("f")
        fitted = view.settings()["camera"]
        self.assertAlmostEqual(angle(fitted)[0], angle(first)[0], places=3)
        self.end(view)

    def test_light_turns_with_control(self):
        view = self.start()
        view.drag(36, 0, modifier="ctrl")
        settings = self.shows_what_it_saves(view)
        self.assertAlmostEqual(settings["env_rotation"], 45, delta=1)
        self.end(view)

    def test_flying(self):
        view = self.start()
        first = view.settings()["camera"]
        view.key("g")
        moves = {}
        for key in "wsadeq":
            before = view.settings()["camera"]["eye"]
            view.xdotool("keydown", key, "sleep", 0.4, "keyup", key)
            after = view.settings()["camera"]["eye"]
            moves[key] = [b - a for a, b in zip(before, after)]
        forward = [t - e for e, t in zip(first["eye"], first["target"])]
        along = {key: sum(m * f for m, f in zip(move, forward)) for key, move in moves.items()}
        self.assertGreater(along["w"], 0.1)
        self.assertLess(along["s"], -0.1)
        self.assertGreater(moves["e"][1], 0.02)
        self.assertLess(moves["q"][1], -0.02)
        self.assertLess(sum(a * d for a, d in zip(moves["a"], moves["d"])), -0.001)
        settings = view.settings()
        self.assertEqual(settings["exposure"], 0)  # E flew
        before = settings["camera"]
        view.drag(40, 0)
        looked = view.settings()["camera"]
        self.assertEqual(looked["eye"], before["eye"])
        self.assertNotEqual(looked["target"], before["target"])
        view.key("g", "e")
        self.assertEqual(view.settings()["exposure"], 0.25)
        self.end(view)

    def test_keys_of_the_picture(self):
        view = self.start()
        view.key("e", "e", "shift+e")
        self.assertEqual(view.settings()["exposure"], 0.25)
        for name in ("reinhard", "aces", "neutral", "none"):
            view.key("m")
            self.assertEqual(self.shows_what_it_saves(view)["tone_map"], name)
        view.key("bracketleft")
        limited = view.settings()["boxes"]
        self.assertGreater(limited, 0)
        view.key("bracketleft")
        self.assertEqual(self.shows_what_it_saves(view)["boxes"], limited - 1)
        view.key("bracketright", "bracketright")
        self.assertEqual(view.settings()["boxes"], 0)
        view.key("b")
        self.assertFalse(view.settings()["background"])
        view.key("b")
        self.shows_what_it_saves(view)
        self.end(view)

    def test_panel_and_help_cover_the_picture(self):
        view = self.start(size=(640, 480))
        self.shows_what_it_saves(view, (640, 480))
        plain = self.screen.capture(view.window, 640, 480)
        for key in ("h", "Tab", "o"):
            view.key(key)
            time.sleep(1)
            covered = self.screen.capture(view.window, 640, 480)
            self.assertGreater(pictures.difference(covered, plain)[1], 2, key)
            view.key("Tab" if key == "Tab" else "Escape")
            self.shows(view, plain, (640, 480))
        self.end(view)

    def test_screenshot_is_what_headless_writes(self):
        view = self.start()
        view.drag(-24, 12)
        view.key("m", "e", "p")
        line = view.wait_for("saved ")
        shot = self.captures / line.strip().rsplit("/", 1)[-1]
        again = self.headless(shot.with_suffix(".json"))
        self.assertEqual(shot.read_bytes(), again.read_bytes())
        self.end(view)

    def test_dropped_files_open(self):
        view = self.start()
        self.screen.drop(view.window, self.studio)  # its name has a space
        view.wait_for("opened ")
        self.assertEqual(self.shows_what_it_saves(view)["environment"], str(self.studio))
        self.screen.drop(view.window, self.other)
        view.wait_for("opened ")
        settings = self.shows_what_it_saves(view)
        self.assertEqual(settings["asset"], str(self.other))
        self.end(view)

    def test_a_broken_file_changes_nothing(self):
        view = self.start()
        before = view.settings()
        broken = self.captures / "broken.ptb"
        broken.write_bytes(self.asset.read_bytes()[:1000])
        for path in (broken, self.captures / "nothing.exr"):
            self.screen.drop(view.window, path)
            view.wait_for(path.name)
        self.assertEqual(self.shows_what_it_saves(view), before)
        self.end(view)

    def test_typed_path_opens(self):
        view = self.start()
        view.key("o")
        time.sleep(1)
        view.xdotool("type", "--delay", 40, str(self.studio))
        view.key("Return")
        view.wait_for("opened ")
        time.sleep(1)
        settings = self.shows_what_it_saves(view)
        self.assertEqual(settings["environment"], str(self.studio))
        self.assertEqual(settings["exposure"], 0)  # what was typed was no command
        self.end(view)

    def test_sizes(self):
        view = self.start()
        for size in ((320, 200), (100, 210), (1, 1), (257, 63)):
            view.xdotool("windowsize", view.window, *size)
            time.sleep(0.5)
        settings = self.shows_what_it_saves(view, (257, 63))
        self.assertEqual(settings["camera"]["size"], [257, 63])
        for size in range(150, 250, 7):  # faster than it draws
            view.xdotool("windowsize", view.window, size, 300 - size)
        view.xdotool("windowunmap", "--sync", view.window)
        time.sleep(0.5)
        view.xdotool("windowmap", "--sync", view.window, "windowfocus", "--sync", view.window, "windowsize", view.window, *SIZE)
        self.shows_what_it_saves(view)
        self.end(view)

    def test_dense_screens(self):
        self.screen.set_density(192)
        self.addCleanup(self.screen.set_density, 96)
        view = self.start()
        self.assertTrue(any("content scale 2" in line for line in view.log), view.log)
        self.assertEqual(self.shows_what_it_saves(view)["camera"]["size"], list(SIZE))
        self.end(view)

    def test_turntable(self):
        view = self.start("--frames", 6)
        view.key("v")
        view.wait_for("recorded 6 frames")
        view.settings()
        frames = sorted((self.captures / "turntable-001").glob("*.png"))
        self.assertEqual([frame.name for frame in frames], [f"frame-{i:04}.png" for i in range(1, 7)])
        first = self.headless(self.saved_file())
        self.assertEqual(frames[0].read_bytes(), first.read_bytes())
        self.assertEqual(len({frame.read_bytes() for frame in frames}), 6)
        self.end(view)

    def test_flight_along_a_path(self):
        view = self.start("--frames", 5)
        view.key("shift+v")
        view.wait_for("a path has two cameras")
        view.key("c")
        view.drag(-36, 0)
        view.key("c")
        view.settings()
        last = self.headless(self.saved_file())
        view.key("shift+v")
        view.wait_for("recorded 5 frames")
        frames = sorted((self.captures / "flight-001").glob("*.png"))
        self.assertEqual(len(frames), 5)
        largest, _ = pictures.difference(pictures.read_png(frames[-1]), pictures.read_png(last))
        self.assertLessEqual(largest, 2)
        self.assertEqual(len({frame.read_bytes() for frame in frames}), 5)
        self.end(view)

    def test_truth_beside_the_picture(self):
        view = self.start("--truth-scene", self.scene)
        view.settings()
        plain = pictures.read_png(self.headless(self.saved_file()))
        view.key("t")
        view.wait_for("the truth is there")
        view.key("Escape")
        camera = view.settings()["camera"]
        view.key("Escape")
        eye, target = (",".join(map(str, camera[name])) for name in ("eye", "target"))
        truth_path = self.captures / "truth.png"
        run("ptbake", "render", self.scene, "--env", self.sky, "-o", truth_path, f"--eye={eye}", f"--target={target}", "--size",
            f"{SIZE[0]}x{SIZE[1]}", "--spp", 64, "--quiet")
        truth, half = pictures.read_png(truth_path), 3 * SIZE[0] // 2
        line = bytes((255, 204, 26))
        both = [p[: half - 3] + line + t[half:] for p, t in zip(plain, truth)]
        self.shows(view, both)
        view.drag(48, 0, start=(96, 60))  # the line
        self.shows(view, [p[: half + 3 * 47] + line + t[half + 3 * 48 :] for p, t in zip(plain, truth)])
        view.key("t")
        self.shows(view, plain)
        self.end(view)

    def test_the_close_button(self):
        view = self.start()
        self.screen.close_window(view.window)
        self.assertEqual(view.process.wait(timeout=viewer.PATIENCE), 0, "".join(view.log))

    def test_without_a_display_it_says_so(self):
        for display in (None, ":98765"):
            environment = {name: value for name, value in os.environ.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY")}
            if display:
                environment["DISPLAY"] = display
            result = subprocess.run([BIN / "ptview", self.asset], env=environment, capture_output=True, text=True, check=False)
            self.assertEqual(result.returncode, 4, result.stderr)
            self.assertIn("--headless", result.stderr)

    def test_without_a_driver_it_says_so(self):
        environment = dict(os.environ, DISPLAY=self.server.name, VK_ICD_FILENAMES="/nonexistent", VK_DRIVER_FILES="/nonexistent")
        result = subprocess.run([BIN / "ptview", self.asset], env=environment, capture_output=True, text=True, check=False)
        self.assertEqual(result.returncode, 4, result.stderr)
        self.assertIn("Vulkan", result.stderr)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]], verbosity=2)
