#pragma once

#include <vector>

#include <Eigen/Geometry>

#include "sim/camera/surface_mesh.h"
#include "sim/robot/robot_model.h"
#include "sim/world/world_model.h"

namespace eod::sim {

/// Consecutive indices of a mesh.
struct IndexRun {
  uint32_t first = 0;
  uint32_t count = 0;
};

/// Triangles with one texture, drawn by one call.
struct DrawRange {
  int texture = 0;  ///< index in kSurfaceTextures
  IndexRun fine;
  IndexRun coarse;             ///< the same shapes in fewer triangles, for far away and for shadows
  Eigen::AlignedBox3f bounds;  ///< static ranges only: in the module's local frame
  bool casts_shadow = true;
};

/// Triangles merged into few calls.
struct DrawList {
  SurfaceMesh mesh;
  std::vector<DrawRange> ranges;
};

/// All visuals of the module, merged per texture within squares of 15 m that are culled together.
/// Throws std::runtime_error for an unknown texture.
DrawList BuildWorldDrawList(const ModuleModel& module);

/// All visuals of the module's movable objects, merged per texture; bone i is object i.
DrawList BuildMovablesDrawList(const ModuleModel& module);

/// All visuals of the robot, merged per texture; bone 1 + i is link i.
DrawList BuildRobotDrawList(const RobotModel& robot);

}  // namespace eod::sim
