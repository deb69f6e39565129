"""A person at the keyboard of `eod-box --keyboard`: presses keys through a pseudo-terminal, and knows
only what the screen says."""

import fcntl
import os
import pty
import re
import select
import struct
import subprocess
import termios
import time

from programs import BIN

UP = "\x1b[A"
REPEAT_S = 0.033  # a keyboard repeats a key that is down 30 times a second
ESCAPES = re.compile(r"\x1b\[[0-9;?]*[A-Za-z]")


class Trainee:
    def __init__(self, *arguments):
        self.master, slave = pty.openpty()
        fcntl.ioctl(slave, termios.TIOCSWINSZ, struct.pack("HHHH", 24, 80, 0, 0))
        self.box = subprocess.Popen([BIN / "eod-box", "--keyboard", *arguments], stdin=slave,
                                    stdout=slave, stderr=subprocess.DEVNULL, start_new_session=True)
        os.close(slave)
        self.unread, self.screen = "", ""
        self.metres, self.looked = 0.0, time.monotonic()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.box.terminate()
        try:
            self.look(0.1)
            self.box.wait(10)
        finally:
            self.box.kill()
            self.box.wait()
            os.close(self.master)

    def look(self, seconds):
        """Watches the screen for so long, and reckons the way driven from the speed it shows."""
        end = time.monotonic() + seconds
        while (left := end - time.monotonic()) > 0:
            if not select.select([self.master], [], [], left)[0]:
                return
            try:
                self.unread += os.read(self.master, 65536).decode(errors="replace")
            except OSError:  # the box has closed its terminal
                return
            *whole, self.unread = self.unread.split("\x1b[H")
            if whole and whole[-1]:
                self.screen = ESCAPES.sub("", whole[-1]).replace("\r", "")
            self.reckon()

    def reckon(self):
        now = time.monotonic()
        speed = self.number(r"Speed +(-?[\d.]+) m/s")
        self.metres += (speed or 0.0) * (now - self.looked)
        self.looked = now

    def number(self, pattern):
        found = re.search(pattern, self.screen)
        return float(found[1]) if found else None

    def shows(self, pattern):
        return re.search(pattern, self.screen) is not None

    def press(self, key):
        os.write(self.master, key.encode())

    def wait(self, pattern, seconds=20):
        self.until(lambda: self.shows(pattern), f"'{pattern}' on the screen", seconds)

    def until(self, condition, what, seconds=20, key=None):
        """Waits until the screen says so, keeping `key` down all the while."""
        end = time.monotonic() + seconds
        while not condition():
            if time.monotonic() > end or self.box.poll() is not None:
                raise AssertionError(f"{what}: not within {seconds} s; the screen:\n{self.screen}")
            if key:
                self.press(key)
            self.look(REPEAT_S)

    def hold(self, key, pattern, seconds=30):
        """Keeps `key` down until the screen shows `pattern`."""
        self.until(lambda: self.shows(pattern), f"'{pattern}' while holding {key!r}", seconds, key)

    def drive(self, metres, seconds=30):
        """Keeps the arrow down until so much more way is driven, and waits until the robot stands."""
        goal = self.metres + metres
        self.until(lambda: self.metres >= goal, f"{metres} m driven", seconds, UP)
        self.wait(r"Speed +-?0\.00 m/s")
