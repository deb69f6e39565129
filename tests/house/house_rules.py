"""The rules of the house, as data: who may include whom, and who may touch the outside world."""

import re

# Folders of the product. Everything else in the tree (build, out, hidden folders) is not looked at.
TOP_FOLDERS = ("batch", "canbridge", "cmake", "console", "dbc", "firmware_emu", "lcmtypes", "lockstep",
               "platform", "programs", "recorder", "scripts", "sim", "tests")

FORBIDDEN_FOLDERS = ("common", "include", "src", "utils")

MAX_LINES = 500
MANY_LINES = 300
MAX_MAIN_LINES = 60

# The stages of the simulator: each sees the ones before it, as far as it needs them.
_SIM_STAGES = {
    "sim/geometry": [],
    "sim/rules": [],
    "sim/sdf": ["sim/geometry"],
    "sim/segments": ["sim/geometry"],
    "sim/robot": ["sim/geometry", "sim/sdf", "sim/segments"],
    "sim/world": ["sim/geometry", "sim/sdf", "sim/segments"],
    "sim/scenario": ["sim/geometry", "sim/rules", "sim/segments", "sim/world"],
    "sim/radio": ["sim/geometry", "sim/rules", "sim/segments", "sim/robot", "sim/world", "sim/scenario"],
    "sim/motion": ["sim/geometry", "sim/robot", "sim/world"],
    "sim/battery": ["sim/geometry", "sim/robot", "sim/motion"],
    "sim/faults": ["sim/geometry", "sim/rules", "sim/segments", "sim/robot", "sim/world", "sim/scenario", "sim/motion"],
    "sim/isectors": ["sim/geometry", "sim/segments", "sim/robot", "sim/world", "sim/motion"],
    "sim/response": ["sim/geometry", "sim/segments", "sim/robot", "sim/world", "sim/motion", "sim/isectors"],
    "sim/bodies": ["sim/geometry", "sim/segments", "sim/robot", "sim/world"],
    "sim/stance": ["sim/geometry", "sim/segments", "sim/robot", "sim/world", "sim/motion", "sim/isectors"],
    "sim/disposal": ["sim/geometry", "sim/rules", "sim/segments", "sim/robot", "sim/world", "sim/motion",
                     "sim/isectors", "sim/response", "sim/bodies"],
    "sim/plume": ["sim/geometry", "sim/rules"],
    "sim/task": ["sim/geometry", "sim/rules", "sim/scenario", "sim/segments", "sim/robot", "sim/world", "sim/motion",
                 "sim/isectors", "sim/response", "sim/disposal"],
    "sim/score": ["sim/geometry", "sim/rules", "sim/scenario", "sim/segments", "sim/robot", "sim/world", "sim/disposal",
                  "sim/task"],
    "sim/alarms": ["sim/geometry", "sim/rules", "sim/scenario", "sim/disposal", "sim/segments", "sim/robot", "sim/world", "sim/motion", "sim/isectors",
                   "sim/response", "sim/task"],
    "sim/camera": ["sim/geometry", "sim/segments", "sim/robot", "sim/world", "sim/plume", "platform"],
}

# Folder to the folders that it may include, itself always among them. A folder that is not here
# (programs, tests) may include all.
MAY_INCLUDE = {
    "lcmtypes": [],
    "platform": ["lcmtypes"],
    "dbc": ["platform"],
    "firmware_emu": ["dbc", "platform", "lcmtypes"],
    "canbridge": ["dbc", "platform", "lcmtypes"],
    "recorder": ["dbc", "platform", "lcmtypes"],
    "console": ["platform", "lcmtypes"],
    "sim": ["platform", "lcmtypes", *_SIM_STAGES],
    "lockstep": ["firmware_emu", "canbridge", "sim", "dbc", "platform", "lcmtypes", *_SIM_STAGES],
    "batch": ["lockstep", "firmware_emu", "canbridge", "sim", "dbc", "platform", "lcmtypes", *_SIM_STAGES],
    **_SIM_STAGES,
}

# Plain values that every folder may know.
KNOWN_TO_ALL = ("platform/time.h",)

# The table of channels is no LCM: everyone at an edge may describe it.
CHANNEL_TABLE = "lcmtypes/channels.h"


class Privilege:
    """Headers or names that only some files may use."""

    def __init__(self, name, allowed, headers=None, code=None):
        self.name = name
        self.allowed = re.compile(allowed)
        self.headers = re.compile(headers) if headers else None
        self.code = re.compile(code) if code else None


PRIVILEGES = (
    Privilege("only sim/sdf includes SDFormat", r"sim/sdf/|tests/", headers=r"(sdf|ignition|gz)/"),
    Privilege("only sim/camera includes OpenGL", r"sim/camera/|tests/", headers=r"(GL|GLES\d?|EGL)/"),
    Privilege("only sim/world and sim/bodies include Bullet", r"sim/(world|bodies)/|tests/",
              headers=r"(bullet/|Bullet(Collision|Dynamics|SoftBody)/|LinearMath/|bt[A-Z])"),
    Privilege("only tests/bench includes Embree and OpenSceneGraph", r"tests/bench/",
              headers=r"(embree\d*|osg[A-Za-z]*|OpenThreads)/"),
    Privilege("only nodes, programs, lockstep, recorder and tests include LCM",
              r"(.*/)?[a-z_]+_node\.(h|cpp)$|programs/|platform/lcm_station\.|platform/run_node\.h$|"
              r"lockstep/|recorder/|tests/", headers=r"lcm/|lcmtypes/|eod/|.*_t\.hpp$"),
    Privilege("only platform touches sockets, poll and signals", r"platform/|tests/",
              headers=r"(sys/(socket|un|epoll|select|poll|timerfd|signalfd)|poll|netdb|netinet/.*|"
                      r"arpa/.*|net/if|linux/(can|net|if).*|signal)(\.h)?$|csignal$"),
    Privilege("only console speaks HTTP", r"console/|tests/", headers=r"boost/(asio|beast)[/.]"),
    Privilege("only platform reads clocks and sleeps", r"platform/|tests/",
              code=r"\b(clock_gettime|gettimeofday|steady_clock|system_clock|high_resolution_clock|"
                   r"nanosleep|usleep|sleep_for|sleep_until|time\s*\(\s*(nullptr|NULL|0)\s*\))"),
)
