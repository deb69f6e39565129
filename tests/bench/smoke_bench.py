#!/usr/bin/python3
"""Pictures a second of the chosen camera while the smoke of an explosion stands before it.

usage: tests/netns tests/bench/smoke_bench.py BIN_DIR

Plays bomb_dropped in real time, recorded, with rules that leave the robot its cameras however near
the blast is: so they go on seeing the smoke at its thickest. Prints, second by second round the
explosion, the pictures of both shown cameras and the processor time that drawing one took. Fails
below 25 a second, on average while smoke stands.
"""

import os
import pathlib
import re
import struct
import sys
import tempfile
import time

os.environ["EOD_BIN_DIR"] = sys.argv[1] if len(sys.argv) == 2 else sys.exit(__doc__)
ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/process"))

from programs import Chain  # noqa: E402

BUS = "udp:239.74.163.2:43113"
SCRIPT = ROOT / "firmware_emu/scripts/bomb_dropped.boxscript"
SCENARIO = ROOT / "sim/scenarios/bomb_ground_m.toml"
PROMISED_FPS = 25
SMOKE_S = 8  # explosion.smoke_s of the rules
EXPLODED = 0x42


def rules_with_cameras_that_survive(folder):
    text = (ROOT / "sim/rules/eod_rules.toml").read_text()
    text, changed = re.subn(r"^lethal_m = [\d.]+", "lethal_m = 0.5", text, flags=re.MULTILINE)
    assert changed == 1, "rules have lethal_m"
    rules = pathlib.Path(folder) / "rules.toml"
    rules.write_text(text)
    return rules


def drawing_s(pid):
    """Processor time [s] of all threads but the one that steps: drawing and compressing."""
    seconds = 0.0
    for task in pathlib.Path(f"/proc/{pid}/task").iterdir():
        if task.name != str(pid):
            seconds += int((task / "schedstat").read_text().split()[0]) / 1e9
    return seconds


def lcm_events(log):
    """(time [s], channel, payload) of each message of an LCM log."""
    with log.open("rb") as file:
        while len(header := file.read(28)) == 28:
            _, _, utime, channel_size, size = struct.unpack(">IQQII", header)
            yield utime / 1e6, file.read(channel_size).decode(), file.read(size)


def is_explosion(message):
    """alarm_t: fingerprint, utime, sequence, source, is_repeat, then the code."""
    return struct.unpack(">h", message[22:24])[0] == EXPLODED


def measure(folder):
    samples = []
    with Chain(BUS, programs=("eod-sim", "eod-canbridge", "eod-recorder", "eod-box"), cameras=True,
               eod_sim=("--scenario", str(SCENARIO), "--rules",
                        str(rules_with_cameras_that_survive(folder))),
               eod_recorder=("--plain", "--out", f"{folder}/run"),
               eod_box=("--script", str(SCRIPT))) as chain:
        sim, box = chain["eod-sim"].process, chain["eod-box"]
        while not box.ended_within(1.0):
            samples.append((time.time(), drawing_s(sim.pid)))
    pictures, exploded = [], None
    for utime, channel, message in lcm_events(pathlib.Path(folder) / "run/run.lcmlog"):
        if channel.startswith("EOD_CAMERA_"):
            pictures.append((utime, channel.removeprefix("EOD_CAMERA_").lower()))
        elif channel == "EOD_ALARM" and exploded is None and is_explosion(message):
            exploded = utime
    return samples, pictures, exploded


def main():
    with tempfile.TemporaryDirectory() as folder:
        samples, pictures, exploded = measure(folder)
    assert exploded is not None, "the charge did not explode"
    print(f"load of the machine {os.getloadavg()[0]:.1f} on {os.cpu_count()} processors")
    print("after explosion  pictures a second      drawing, ms a picture")
    for (begin, used), (end, used_then) in zip(samples, samples[1:]):
        if not -5 <= begin - exploded <= SMOKE_S:
            continue
        seen = [camera for utime, camera in pictures if begin <= utime < end]
        rates = "  ".join(f"{name} {seen.count(name) / (end - begin):4.1f}" for name in sorted(set(seen)))
        print(f"{begin - exploded:+12.1f} s  {rates:24} {1e3 * (used_then - used) / max(len(seen), 1):6.1f}")
    chosen = [t for t, camera in pictures if camera == "mast" and 0 <= t - exploded <= SMOKE_S]
    rate = (len(chosen) - 1) / (chosen[-1] - chosen[0])
    print(f"mast camera while smoke stands: {rate:.1f} pictures a second (promised {PROMISED_FPS})")
    return 0 if rate >= PROMISED_FPS else 1


if __name__ == "__main__":
    sys.exit(main())
