#!/usr/bin/python3
"""How long the operator waits: many presses and many contacts on the running programs.

    tests/netns tests/bench/latency_bench.py build/release/bin [--cameras]

Prints both delays of summary.json (recorder/latency_matcher.h says what they are) beside what the
product promises: one step of 4 ms, and 1 ms to move or 2 ms to light the lamp. The peer is the
machine: how late it wakes a program that does nothing but wait for the same 4 ms, in the same run.
"""

import argparse
import json
import os
import pathlib
import statistics
import sys
import tempfile
import threading
import time

HERE = pathlib.Path(__file__).resolve().parent
BUS = "udp:239.74.163.2:43113"
PROMISED_MS = {"button_to_pose": 4 + 1, "contact_to_lamp_frame": 4 + 2}

POWER_UP = """
wait state standby within 3s
key operate
deadman enabled
wait link up within 5s
reset
start
wait robot operate within 3s
menu module flat
menu start
wait module flat within 5s
speed high
"""
# 250 ms of standing between two presses; odd lengths, so that presses fall on every phase of a step.
PRESS = "hold M19 for {held}ms\nwait {rest}ms\nhold M20 for {held}ms\nwait {rest}ms\n"
TO_WALL = "hold M01 until lamp collision on within 8s\nwait 300ms\n"
CONTACT = "hold M02 for 200ms\nwait 301ms\nhold M01 until lamp collision on within 3s\nwait {rest}ms\n"


def script(presses, contacts):
    text = POWER_UP
    for i in range(presses // 2):
        text += PRESS.format(held=101 + i % 7, rest=251 + i % 13)
    if contacts > 0:
        text += TO_WALL
    for i in range(contacts - 1):
        text += CONTACT.format(rest=301 + i % 17)
    return text


class Waiter(threading.Thread):
    """Waits for every 4 ms, with the programs' own priority, and notes how late [ms] it wakes."""

    def __init__(self):
        super().__init__(daemon=True)
        self.late_ms = []
        self.ended = threading.Event()

    def run(self):
        try:
            os.sched_setscheduler(0, os.SCHED_FIFO, os.sched_param(10))
        except PermissionError:
            pass
        due = time.monotonic() + 0.004
        while not self.ended.wait(due - time.monotonic()):
            self.late_ms.append((time.monotonic() - due) * 1e3)
            due = max(due + 0.004, time.monotonic())


def measure(arguments, folder):
    from programs import Chain, Program
    operator = pathlib.Path(folder) / "latency.boxscript"
    operator.write_text(script(arguments.presses, arguments.contacts), encoding="utf-8")
    chain = Chain(BUS, programs=("eod-sim", "eod-canbridge"), cameras=arguments.cameras)
    limit = 60 + arguments.presses + 4 * arguments.contacts
    with chain:
        recorder = Program("eod-recorder", "--bus", BUS, "--out", folder, "--until", "script-done",
                           "--plain", folder=folder)
        recorder.wait_until((pathlib.Path(folder) / "run.lcmlog").exists, "recording")
        box = Program("eod-box", "--bus", BUS, "--script", str(operator), "--stay", folder=folder)
        try:
            if not recorder.ended_within(limit):
                raise AssertionError(f"not done within {limit} s:\n{box.text()}")
        finally:
            box.end()
            recorder.end()
    return json.loads((pathlib.Path(folder) / "summary.json").read_text(encoding="utf-8"))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("bin", help="folder of the programs")
    parser.add_argument("--presses", type=int, default=300)
    parser.add_argument("--contacts", type=int, default=50)
    parser.add_argument("--cameras", action="store_true", help="let the cameras run beside")
    arguments = parser.parse_args()
    os.environ["EOD_BIN_DIR"] = arguments.bin
    sys.path.insert(0, str(HERE.parent / "process"))
    waiter = Waiter()
    waiter.start()
    with tempfile.TemporaryDirectory() as folder:
        summary = measure(arguments, folder)
    waiter.ended.set()
    waiter.join()
    for name, promised in PROMISED_MS.items():
        seen = summary["latency_ms"][name]
        print(f"{name}: p50 {seen['p50']:.2f} ms, p99 {seen['p99']:.2f} ms, n {seen['n']}"
              f" (promised p99: {promised} ms)")
    late = statistics.quantiles(waiter.late_ms, n=100)
    print(f"the machine wakes a waiting program late by p50 {late[49]:.2f} ms, p99 {late[98]:.2f} ms,"
          f" at most {max(waiter.late_ms):.1f} ms, n {len(waiter.late_ms)}")
    step = summary["step"]
    print(f"step: {step['period_ms']} ms, {step['overruns']} overruns"
          f" in {summary['sim_seconds']:.0f} s; cameras {summary['camera']['fps']} a second")
    return 0 if summary["result"] == "success" else 1


if __name__ == "__main__":
    sys.exit(main())
