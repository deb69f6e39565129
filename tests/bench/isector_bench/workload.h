#pragma once

#include <span>
#include <vector>

#include "sim/segments/segment.h"
#include "tests/bench/isector_bench/path.h"
#include "tests/bench/isector_bench/scene.h"

namespace eod::bench {

inline constexpr int kLinesPerBump = 6;
inline constexpr int kLinesPerFrame = kLegs + kBumps * kLinesPerBump;  ///< 63
inline constexpr int kSightLinesPerFrame = 8;
inline constexpr int kAimedLines = 6000, kAimedLinesPerFrame = 60;

inline constexpr double kLegLength = 2, kBumpLength = 0.3, kSightLength = 200;  ///< [m]

/// The short lines of a robot, frame after frame: three of TRIPOD, which stay vertical, then six of
/// each BUMP, along +X, -X, +Y, -Y, +Z, -Z of the isector's own pose. `group` is the number of the
/// isector: TRIPOD 0, the BUMPs 1 to 10.
std::vector<sim::SegmentQuery> ShortLines(std::span<const RobotPose> path);

/// Lines of sight of 200 m from 1.1 m above the robot: eight headings a frame, all round, between
/// 3 degrees downwards and 1.5 upwards. Each is an isector of its own: groups 11 to 18.
std::vector<sim::SegmentQuery> SightLines(std::span<const RobotPose> path);

/// Lines of 0.3 m that aim at where meshes leak: two thirds at random points of edges that two
/// triangles share, one third at corners. Every triangle of that edge or corner is met by 15
/// degrees or more from its front, so the line cannot pass: whatever misses it leaks. In frames of
/// 60 lines, all of one frame within 1.5 m of a place of the robot; groups of six.
std::vector<sim::SegmentQuery> AimedLines(const Scene& scene, std::span<const RobotPose> path);

}  // namespace eod::bench
