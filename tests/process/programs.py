"""Starts the real programs for a test and ends them again, whatever happens."""

import os
import pathlib
import signal
import subprocess
import tempfile
import time

BIN = pathlib.Path(os.environ["EOD_BIN_DIR"])
ROOT = pathlib.Path(__file__).resolve().parents[2]


class Program:
    """One running program of the product; what it prints is kept in a file."""

    def __init__(self, name, *arguments, folder):
        self.name = name
        self.output = pathlib.Path(folder) / f"{name}.log"
        with self.output.open("w") as output:
            self.process = subprocess.Popen([BIN / name, *arguments], stdin=subprocess.DEVNULL,
                                            stdout=output, stderr=subprocess.STDOUT)

    def text(self):
        return self.output.read_text(errors="replace")

    def wait_for(self, text, seconds=20):
        """Waits until the program has printed `text`; fails loudly if it ends or never does."""
        return self.wait_until(lambda: text in self.text(), f"'{text}' printed", seconds)

    def wait_until(self, condition, what, seconds=20):
        end = time.monotonic() + seconds
        while not condition():
            if self.process.poll() is not None and not condition():
                raise AssertionError(f"{self.name} ended with {self.process.returncode} "
                                     f"before {what}:\n{self.text()}")
            if time.monotonic() > end:
                raise AssertionError(f"{self.name}: {what}: not within {seconds} s:\n{self.text()}")
            self.ended_within(0.01)

    def ended_within(self, seconds):
        """Gives the program time, but no longer than it lives."""
        try:
            self.process.wait(seconds)
            return True
        except subprocess.TimeoutExpired:
            return False

    def end(self, how=signal.SIGTERM, seconds=10):
        """Asks the program to end and returns its exit status."""
        if self.process.poll() is None:
            self.process.send_signal(how)
        try:
            return self.process.wait(seconds)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()
            raise AssertionError(f"{self.name} did not end within {seconds} s of {how!r}:\n"
                                 f"{self.text()}") from None


class Chain:
    """Several programs on one bus, ready when the block is entered, ended when it is left."""

    ARGUMENTS = {"eod-sim": ("--no-cameras",), "eod-canbridge": (), "eod-box": ()}

    def __init__(self, bus, programs=("eod-sim", "eod-canbridge", "eod-box"), cameras=False,
                 **arguments):
        self.bus, self.names = bus, programs
        self.arguments = {**self.ARGUMENTS, **({"eod-sim": ()} if cameras else {})}
        self.extra = {name.replace("_", "-"): value for name, value in arguments.items()}
        self.programs = {}
        self.folder = tempfile.TemporaryDirectory()

    def start(self, name):
        bus = () if name in ("eod-sim", "eod-console") else ("--bus", self.bus)
        program = Program(name, *bus, *self.arguments.get(name, ()), *self.extra.get(name, ()),
                          folder=self.folder.name)
        self.programs[name] = program
        program.wait_for("ready")
        return program

    def __getitem__(self, name):
        return self.programs[name]

    def __enter__(self):
        try:
            for name in self.names:
                self.start(name)
        except BaseException:
            self.__exit__()
            raise
        return self

    def __exit__(self, *_):
        try:
            for program in self.programs.values():
                program.end()
        finally:
            for program in self.programs.values():
                if program.process.poll() is None:
                    program.process.kill()
                    program.process.wait()
            self.folder.cleanup()
