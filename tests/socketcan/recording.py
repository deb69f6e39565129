"""Reads what a run left behind: candump text, and LCM's log."""

import re
import struct

CANDUMP = re.compile(r"\((\d+\.\d+)\) (\w+) ([0-9A-F]{3}|[0-9A-F]{8})#(R|[0-9A-F]*)")


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


def robot_states(file):
    """(seconds, (x, y) in metres, speed in m/s): the first fields of robot_state_t."""
    for seconds, payload in lcm_events(file, "EOD_ROBOT_STATE"):
        fields = struct.unpack_from(">q qqb3d 3d d", payload)
        yield seconds, fields[4:6], fields[10]


def link_states(file):
    """(seconds, fields by name) of link_status_t."""
    numbers = ("rx", "tx", "lost", "tx_dropped", "crc_errors", "counter_errors", "length_errors",
               "unknown_ids", "error_frames", "bus_restarts")
    for seconds, payload in lcm_events(file, "EOD_LINK_STATUS"):
        _, _, system_state, size = struct.unpack_from(">qqbi", payload)
        offset = 21 + size
        fields = struct.unpack_from(">bid10qbi", payload, offset)
        fault = payload[offset + struct.calcsize(">bid10qbi"):-1].decode()
        yield seconds, dict(zip(numbers, fields[3:13]), system_state=system_state,
                            bus_state=fields[0], fault=fault)


def raised_alarms(file):
    """(seconds, code) of each alarm that was raised, of the bridge and of the simulator."""
    for seconds, payload in lcm_events(file, "EOD_ALARM"):
        _, _, _, _, is_repeat, code, is_raised = struct.unpack_from(">qqib?h?", payload)
        if not is_repeat and is_raised:
            yield seconds, code
