"""Reads what a run left behind: candump text, and LCM's log."""

import pathlib
import re
import struct

LCMTYPES = pathlib.Path(__file__).resolve().parents[2] / "lcmtypes"
CANDUMP = re.compile(r"\((\d+\.\d+)\) (\w+) ([0-9A-F]{3}|[0-9A-F]{8})#(R|[0-9A-F]*)")
FIELD = re.compile(r"^\s*(int8_t|int16_t|int32_t|int64_t|float|double|boolean|string)\s+"
                   r"(\w+)(?:\[(\w+)\])?;", re.MULTILINE)
FORMATS = {"int8_t": "b", "int16_t": "h", "int32_t": "i", "int64_t": "q", "float": "f",
           "double": "d", "boolean": "?"}


def can_frames(file, interface, arbitration_id):
    """(seconds, data) of each frame with a standard identifier, in the order of the bus."""
    for line in file.read_text().splitlines():
        match = CANDUMP.match(line)
        if match and match[2] == interface and match[3] == f"{arbitration_id:03X}":
            yield float(match[1]), bytes.fromhex(match[4].replace("R", ""))


def lcm_events(file, channel):
    """(seconds, payload) of each message of one channel. Format: lcm-logger's event log."""
    log, offset = file.read_bytes(), 0
    while offset + 28 <= len(log):
        sync, _, utime, name_size, size = struct.unpack_from(">IqqII", log, offset)
        if sync != 0xEDA1DA01:
            raise AssertionError(f"{file}: no event at byte {offset}")
        name = log[offset + 28:offset + 28 + name_size].decode()
        payload = log[offset + 28 + name_size:offset + 28 + name_size + size]
        if name == channel:
            yield utime / 1e6, payload
        offset += 28 + name_size + size


def messages(file, channel, type_name):
    """(seconds, fields by name) of each message of one channel, as its .lcm file declares it."""
    declared = FIELD.findall((LCMTYPES / f"{type_name}.lcm").read_text())
    for seconds, payload in lcm_events(file, channel):
        fields, offset = {}, 8  # behind the type's fingerprint
        for kind, name, dimension in declared:
            if kind == "string":
                size, = struct.unpack_from(">i", payload, offset)
                fields[name] = payload[offset + 4:offset + 3 + size].decode()
                offset += 4 + size
                continue
            count = (int(dimension) if dimension.isdigit() else fields[dimension]) if dimension else 1
            values = struct.unpack_from(f">{count}{FORMATS[kind]}", payload, offset)
            fields[name] = values if dimension else values[0]
            offset += struct.calcsize(f">{count}{FORMATS[kind]}")
        if offset != len(payload):
            raise AssertionError(f"{type_name}: {len(payload)} bytes, declared are {offset}")
        yield seconds, fields


def robot_states(file):
    """(seconds, position, speed in m/s) of each step."""
    for seconds, state in messages(file, "EOD_ROBOT_STATE", "robot_state_t"):
        yield seconds, state["position_m"], state["speed_mps"]


def link_states(file):
    return messages(file, "EOD_LINK_STATUS", "link_status_t")


def raised_alarms(file):
    """(seconds, code) of each alarm that was raised, of the bridge and of the simulator."""
    for seconds, alarm in messages(file, "EOD_ALARM", "alarm_t"):
        if alarm["raised"] and not alarm["is_repeat"]:
            yield seconds, alarm["code"]
