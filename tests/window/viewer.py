# SPDX-License-Identifier: Apache-2.0
"""An X server without a screen, and ptview in a window on it."""
import json
import os
import queue
import subprocess
import threading
import time

PATIENCE = 60  # seconds, for anything: a loaded machine is no failure


class XServer:
    """Xvfb on whatever display is free."""

    def __init__(self):
        read, write = os.pipe()
        command = ["Xvfb", "-displayfd", str(write), "-screen", "0", "1024x768x24", "-nolisten", "tcp"]
        self.process = subprocess.Popen(command, pass_fds=(write,), stderr=subprocess.DEVNULL)
        os.close(write)
        with os.fdopen(read) as answer:
            self.name = ":" + answer.readline().strip()
        if self.name == ":":
            raise RuntimeError("Xvfb does not start")

    def close(self):
        self.process.terminate()
        self.process.wait()


class Viewer:
    """ptview with validation; its log is read as it comes."""

    def __init__(self, program, display, captures, *arguments):
        self.display, self.captures = display, captures
        environment = dict(os.environ, DISPLAY=display)
        environment.pop("WAYLAND_DISPLAY", None)
        command = [program, "--verbose", "--validation", "--device", "llvmpipe", "--captures", captures, *arguments]
        self.process = subprocess.Popen(
            [str(word) for word in command], env=environment, stderr=subprocess.PIPE, stdout=subprocess.DEVNULL, text=True
        )
        self.lines, self.log = queue.Queue(), []
        self.reader = threading.Thread(target=self.read, daemon=True)
        self.reader.start()
        self.wait_for("picture complete")
        self.window = int(self.xdotool("search", "--onlyvisible", "--pid", str(self.process.pid)).split()[0])
        self.xdotool("windowfocus", "--sync", self.window)

    def read(self):
        for line in self.process.stderr:
            self.log.append(line)
            self.lines.put(line)

    def wait_for(self, text):
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end:
            try:
                line = self.lines.get(timeout=0.2)
            except queue.Empty:
                if self.process.poll() is not None:
                    break
                continue
            if text in line:
                return line
        raise AssertionError(f"'{text}' was not said:\n{''.join(self.log)}")

    def xdotool(self, *arguments):
        command = ["xdotool", *map(str, arguments)]
        return subprocess.run(command, env=dict(os.environ, DISPLAY=self.display), check=True, capture_output=True, text=True).stdout

    def key(self, *keys):
        self.xdotool("key", "--delay", 30, *keys)

    def drag(self, x, y, button=1, modifier=None, start=(100, 60)):
        """In steps, as a hand does, by x and y pixels."""
        self.xdotool("mousemove", "--window", self.window, *start, "sleep", 0.1)
        if modifier:
            self.xdotool("keydown", modifier, "sleep", 0.1)
        self.xdotool("mousedown", button, "sleep", 0.1)
        for _ in range(4):
            self.xdotool("mousemove_relative", "--sync", "--", x // 4, y // 4, "sleep", 0.05)
        self.xdotool("mouseup", button, "sleep", 0.1)
        if modifier:
            self.xdotool("keyup", modifier, "sleep", 0.1)

    def settings(self):
        """What Ctrl+S saves: events before it have been dealt with."""
        self.key("ctrl+s")
        line = self.wait_for("saved ")
        path = self.captures / line.strip().rsplit("/", 1)[-1]
        return json.loads(path.read_text())

    def quit(self):
        """Ends it by its key; returns the exit code, which is not 0 if validation found anything."""
        if self.process.poll() is None:
            self.xdotool("windowfocus", "--sync", self.window)
            self.key("ctrl+q")
        return self.process.wait(timeout=PATIENCE)

    def kill(self):
        if self.process.poll() is None:
            self.process.kill()
        self.process.wait()
        self.reader.join()
        self.process.stderr.close()
