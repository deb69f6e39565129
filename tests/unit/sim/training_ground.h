#pragma once

#include <memory>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "sim/world/world_model.h"

namespace eod::sim {

/// The training ground that the product ships; read once.
inline const WorldModel& TrainingGroundModel() {
  static const WorldModel model = LoadWorld(EOD_DATA_DIR "/sim/worlds/training_ground.sdf");
  return model;
}

/// One module of it, measured by casting segments against the world built of it. All lengths in
/// metres, all points in the module's local frame.
class BuiltModule {
 public:
  explicit BuiltModule(int id) : module_(TrainingGroundModel().Module(id)) {
    world_ = BuildWorld(module_);
  }
  const ModuleModel& model() const { return module_; }

  struct Met {
    double range = -1;  ///< -1: nothing
    std::string object;
    uint32_t object_class = 0;
    Eigen::Vector3d point = Eigen::Vector3d::Zero();
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  };
  /// What a line of 10 m from `start` meets first, among objects of the proxy.
  Met Look(const Eigen::Vector3d& start, const Eigen::Vector3d& direction,
           uint32_t proxy = kBumpProxy) const {
    const SegmentQuery query{.start = start,
                             .direction = direction,
                             .length = 10,
                             .class_mask = module_.class_bit | proxy};
    SegmentHit hit;
    CastMemory memory;
    world_->Cast({&query, 1}, {&hit, 1}, memory);
    if (!hit.hit) return {};
    return {hit.range, world_->ObjectName(hit.object), hit.object_class, hit.point, hit.normal};
  }
  /// Height of what lies below (x, y, 5).
  double HeightAt(double x, double y, uint32_t proxy = kBumpProxy) const {
    const Met met = Look({x, y, 5}, -Eigen::Vector3d::UnitZ(), proxy);
    return met.range < 0 ? -100 : met.point.z();
  }

  /// As World has it, for what is stood on.
  std::optional<double> LevelGroundIn(const Eigen::AlignedBox3d& box) const {
    CastMemory memory;
    return world_->LevelGroundIn(box, module_.class_bit | kClampProxy, memory);
  }

 private:
  const ModuleModel& module_;
  std::unique_ptr<World> world_;
};

}  // namespace eod::sim
