#!/usr/bin/env python3
"""The checker must find what it is for: each rule is broken once, in a small tree of its own."""

import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
LEFT_FOR_LATER = "TO" + "DO"


def run_checker(tree):
    """Lines that the checker prints for a tree {path: text}, and its exit status."""
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        shutil.copy(HERE.parents[1] / ".clang-format", root / ".clang-format")
        for name, text in tree.items():
            path = root / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
        run = subprocess.run([sys.executable, str(HERE / "check_house.py"), str(root)],
                             capture_output=True, text=True, check=False)
    return run.stdout.splitlines()[:-1], run.returncode


class CheckHouse(unittest.TestCase):
    def assert_violation(self, tree, *expected):
        lines, status = run_checker(tree)
        self.assertEqual(lines, list(expected))
        self.assertEqual(status, 1)

    def assert_clean(self, tree):
        lines, status = run_checker(tree)
        self.assertEqual(lines, [])
        self.assertEqual(status, 0)

    def test_takes_what_is_allowed(self):
        self.assert_clean({
            "sim/simulator.h": '#pragma once\n\n#include "sim/response/response.h"\n',
            "sim/response/response.h": '#pragma once\n\n#include "platform/time.h"\n'
                                       '#include "sim/isectors/isector_set.h"\n',
            "sim/sim_node.cpp": "#include <lcm/lcm-cpp.hpp>\n",
            "sim/camera/sky.cpp": "#include <GL/gl.h>\n",
            "sim/sdf/reader.cpp": "#include <sdf/sdf.hh>\n",
            "lockstep/rig.cpp": '#include <lcm/lcm-cpp.hpp>\n\n#include "canbridge/bridge.h"\n',
            "sim/world/other.cpp": "#include <btBulletCollisionCommon.h>\n",
            "canbridge/describe.cpp": '#include "lcmtypes/channels.h"\n',
            "platform/clock.cpp": "#include <csignal>\n\nauto now = std::chrono::steady_clock::now();\n",
            "programs/eod_sim.cpp": '#include "lockstep/rig.h"\n\nint main() {}\n',
            "tests/bench/peer.cpp": "#include <embree3/rtcore.h>\n#include <osg/Node>\n",
            "tests/unit/x_test.cpp": '#include <poll.h>\n\n#include "programs/options.h"\n',
            "dbc/a.cpp": "// steady_clock is only named here\n",
        })

    def test_the_programs_never_include_each_other(self):
        self.assert_violation(
            {"canbridge/a.cpp": '#include "dbc/database.h"\n#include "sim/simulator.h"\n'},
            'canbridge/a.cpp:2: canbridge may not include sim: "sim/simulator.h"')
        self.assert_violation(
            {"sim/a.cpp": '#include "firmware_emu/control_box.h"\n'},
            'sim/a.cpp:1: sim may not include firmware_emu: "firmware_emu/control_box.h"')
        self.assert_violation(
            {"firmware_emu/a.cpp": '#include "canbridge/bridge.h"\n'},
            'firmware_emu/a.cpp:1: firmware_emu may not include canbridge: "canbridge/bridge.h"')

    def test_arrows_go_one_way(self):
        self.assert_violation(
            {"platform/a.cpp": '#include "dbc/database.h"\n'},
            'platform/a.cpp:1: platform may not include dbc: "dbc/database.h"')
        self.assert_violation(
            {"sim/motion/a.h": '#pragma once\n\n#include "sim/isectors/isector_set.h"\n'},
            "sim/motion/a.h:3: sim/motion may not include sim/isectors: "
            '"sim/isectors/isector_set.h"')
        self.assert_violation(
            {"sim/world/a.cpp": '#include "sim/robot/robot_model.h"\n'},
            'sim/world/a.cpp:1: sim/world may not include sim/robot: "sim/robot/robot_model.h"')
        self.assert_violation(
            {"sim/camera/a.cpp": '#include "sim/response/response.h"\n'},
            'sim/camera/a.cpp:1: sim/camera may not include sim/response: "sim/response/response.h"')
        self.assert_violation(
            {"sim/task/a.cpp": '#include "sim/simulator.h"\n'},
            'sim/task/a.cpp:1: sim/task may not include sim: "sim/simulator.h"')

    def test_nobody_includes_programs_or_lockstep(self):
        self.assert_violation(
            {"recorder/a.cpp": '#include "lockstep/rig.h"\n#include "programs/options.h"\n'},
            'recorder/a.cpp:1: recorder may not include lockstep: "lockstep/rig.h"',
            'recorder/a.cpp:2: recorder may not include programs: "programs/options.h"')

    def test_libraries_stay_behind_their_walls(self):
        self.assert_violation(
            {"sim/world/a.cpp": "#include <sdf/sdf.hh>\n"},
            "sim/world/a.cpp:1: only sim/sdf includes SDFormat: sdf/sdf.hh")
        self.assert_violation(
            {"sim/robot/a.cpp": "#include <GL/osmesa.h>\n"},
            "sim/robot/a.cpp:1: only sim/camera includes OpenGL: GL/osmesa.h")
        self.assert_violation(
            {"sim/segments/a.cpp": "#include <LinearMath/btVector3.h>\n"
                                   "#include <btBulletCollisionCommon.h>\n"},
            "sim/segments/a.cpp:1: only sim/world and sim/bodies include Bullet: LinearMath/btVector3.h",
            "sim/segments/a.cpp:2: only sim/world and sim/bodies include Bullet: btBulletCollisionCommon.h")
        self.assert_violation(
            {"sim/world/a.cpp": "#include <embree3/rtcore.h>\n#include <osgSim/LineOfSight>\n"},
            "sim/world/a.cpp:1: only tests/bench includes Embree and OpenSceneGraph: "
            "embree3/rtcore.h",
            "sim/world/a.cpp:2: only tests/bench includes Embree and OpenSceneGraph: "
            "osgSim/LineOfSight")
        self.assert_violation(
            {"canbridge/bridge.cpp": '#include <lcm/lcm-cpp.hpp>\n\n#include "eod/alarm_t.hpp"\n'},
            "canbridge/bridge.cpp:1: only nodes, programs, lockstep, recorder and tests include LCM: "
            "lcm/lcm-cpp.hpp",
            "canbridge/bridge.cpp:3: only nodes, programs, lockstep, recorder and tests include LCM: "
            "eod/alarm_t.hpp")

    def test_only_the_platform_touches_the_outside(self):
        self.assert_violation(
            {"canbridge/a.cpp": "#include <csignal>\n\n#include <poll.h>\n#include <sys/socket.h>\n"},
            "canbridge/a.cpp:1: only platform touches sockets, poll and signals: csignal",
            "canbridge/a.cpp:3: only platform touches sockets, poll and signals: poll.h",
            "canbridge/a.cpp:4: only platform touches sockets, poll and signals: sys/socket.h")
        self.assert_violation(
            {"sim/a.cpp": "/* two\n * lines */\nauto t = std::chrono::steady_clock::now();\n"},
            "sim/a.cpp:3: only platform reads clocks and sleeps: steady_clock")

    def test_includes_go_from_the_root(self):
        self.assert_violation(
            {"dbc/a.cpp": '#include "database.h"\n'},
            'dbc/a.cpp:1: includes go from the root of the tree: "database.h"')

    def test_sizes(self):
        self.assert_violation(
            {"dbc/a.cpp": "int a;\n" * 501},
            "dbc/a.cpp:501: a file has at most 500 lines, this 501")
        self.assert_violation(
            {"programs/a.cpp": "int main() {}\n" + "int a;\n" * 60},
            "programs/a.cpp:61: a main has at most 60 lines, this 61")
        lines, status = run_checker({"dbc/a.cpp": "int a;\n" * 301})
        self.assertEqual((lines, status), (["dbc/a.cpp:301: warning: 301 lines"], 0))

    def test_nothing_is_left_for_later(self):
        self.assert_violation(
            {"scripts/demo": f"#!/bin/sh\n# {LEFT_FOR_LATER}: all of it\n"},
            f"scripts/demo:2: nothing is left for later: {LEFT_FOR_LATER}")

    def test_folder_names(self):
        self.assert_violation(
            {"sim/utils/a.cpp": "int a;\n"}, "sim/utils:1: no folder is named utils")

    def test_format(self):
        self.assert_violation(
            {"dbc/a.cpp": "int a;\nint   b;\n"},
            "dbc/a.cpp:2: is not as clang-format has it; run clang-format -i")

    def test_an_empty_tree_is_no_success(self):
        self.assertEqual(run_checker({})[1], 1)


if __name__ == "__main__":
    unittest.main()
