#include "tests/bench/paper_claims/module_masks.h"

#include <memory>

#include "sim/all_modules.h"
#include "sim/isectors/isector_set.h"
#include "sim/simulator.h"
#include "tests/bench/paper_claims/every_polygon.h"

namespace eod::claims {
namespace {

constexpr int kModules = 5;
constexpr double kWorldSize = 3000;  // [m] of the source paper
constexpr double kSpacing = kWorldSize / kModules;

using LinkPoseList = std::vector<Eigen::Isometry3d>;

/// Link poses at `frames` moments, evenly from the start to the wall.
std::vector<LinkPoseList> DriveToWall(const sim::RobotModel& robot, const sim::WorldModel& world,
                                      int frames) {
  sim::Scenario scenario;
  scenario.module = 1;
  sim::SimulatorConfig config;
  config.exercise = sim::LoadRules(EOD_DATA_DIR "/sim/rules/eod_rules.toml");
  sim::Simulator simulator(robot, world, scenario, config);
  sim::OperatorCommand command;
  command.motion_permitted = true;
  command.motion_rate[sim::kDriveForward] = 1;
  std::vector<sim::RobotState> states;
  while (simulator.last().contact_parts == 0) {
    command.stamp += sim::SimulatorConfig{}.period;
    states.push_back(simulator.Step(command.stamp, command).state);
  }
  std::vector<LinkPoseList> drive(static_cast<size_t>(frames));
  for (size_t i = 0; i < drive.size(); ++i) {
    const size_t at = (states.size() - 1) * i / (drive.size() > 1 ? drive.size() - 1 : 1);
    sim::LinkPoses(robot, states[at], drive[i]);
  }
  return drive;
}

sim::WorldModel FiveCopies(const sim::ModuleModel& module, double spacing) {
  sim::WorldModel world;
  for (int i = 0; i < kModules; ++i) {
    sim::ModuleModel copy = module;
    copy.id = i + 1;
    copy.class_bit = 1u << i;
    copy.p_WM = Eigen::Vector3d(i * spacing, 0, 0);
    for (sim::CollisionTriangle& triangle : copy.triangles) {
      triangle.class_mask = (triangle.class_mask & ~sim::kAnyModule) | copy.class_bit;
    }
    world.modules.push_back(std::move(copy));
  }
  return world;
}

/// Work of a whole drive, and the range of every segment of it; -1 without a hit.
struct Driven {
  sim::CastCounters work;
  std::vector<double> ranges;
};

Driven CastAlong(const std::vector<LinkPoseList>& drive, const sim::RobotModel& robot,
                 const sim::World& world, bool module_masks) {
  sim::IsectorSet isectors(robot, 1, sim::Coverage::kExtended, {.module_masks = module_masks});
  Driven driven;
  for (const LinkPoseList& X_ML : drive) {
    isectors.Cast(world, X_ML, sim::SetOf(sim::kDriveForward));
    const sim::CastCounters& step = isectors.counters();
    driven.work.segments += step.segments;
    driven.work.blocks += step.blocks;
    driven.work.candidates += step.candidates;
    driven.work.exact += step.exact;
    for (const sim::CastSegment& cast : isectors.segments()) {
      driven.ranges.push_back(cast.hit.hit ? cast.hit.range : -1);
    }
  }
  return driven;
}

}  // namespace

MaskCounts CountWithMasks(const sim::RobotModel& robot, const sim::WorldModel& world, int frames) {
  const sim::ModuleModel& flat = world.Module(1);
  const std::vector<LinkPoseList> drive = DriveToWall(robot, world, frames);
  MaskCounts result{.triangles_each = static_cast<int64_t>(flat.triangles.size()),
                    .frames = frames,
                    .spacing_m = kSpacing,
                    .counts = {}};
  for (const bool side_by_side : {false, true}) {
    const sim::WorldModel five = FiveCopies(flat, side_by_side ? kSpacing : 0);
    const sim::ModuleModel all = sim::WithAllModules(five, five.Module(1));
    const std::unique_ptr<sim::World> block_tree = sim::BuildWorld(all);
    const EveryPolygon every_polygon(all.triangles);
    const sim::World& no_tree = every_polygon;
    const std::vector<double> answers = CastAlong(drive, robot, *block_tree, true).ranges;
    for (const bool by_tree : {false, true}) {
      const sim::World& dut = by_tree ? *block_tree : no_tree;
      const Driven masked = CastAlong(drive, robot, dut, true);
      const Driven unmasked = CastAlong(drive, robot, dut, false);
      result.counts.push_back(
          {.layout = side_by_side ? "side_by_side" : "one_place",
           .traversal = by_tree ? "block_tree" : "every_polygon",
           .masked = masked.work,
           .unmasked = unmasked.work,
           .same_answers = masked.ranges == answers && unmasked.ranges == answers});
    }
  }
  return result;
}

}  // namespace eod::claims
