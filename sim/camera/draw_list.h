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
  Eigen::AlignedBox3f bounds;  ///< in the frame of the bone; the static world's is the module's
  int bone = 0;
  bool casts_shadow = true;
};

/// What lies in a square of one texture once more, for when it is so far away that one call and few
/// triangles must do for all of it. Small things are not in it.
struct DrawBlock {
  int texture = 0;
  IndexRun run;
  Eigen::AlignedBox3f bounds;
  size_t first = 0;  ///< of `count` squares of the next smaller size
  size_t count = 0;
};

/// Triangles merged into few calls.
struct DrawList {
  SurfaceMesh mesh;
  std::vector<DrawRange> ranges;
  // Static world only:
  std::vector<DrawBlock> blocks;   ///< of ranges
  std::vector<DrawBlock> regions;  ///< of blocks
};

/// All visuals of the module, merged per texture within squares of 15 m that are culled together,
/// blocks of 30 m and regions of 120 m. Meshes larger than a square are cut along them.
/// Throws std::runtime_error for an unknown texture.
DrawList BuildWorldDrawList(const ModuleModel& module);

/// All visuals of the module's movable objects, merged per texture and bone; bone i is object i.
DrawList BuildMovablesDrawList(const ModuleModel& module);

/// All visuals of the robot, merged per texture and bone; bone 1 + i is link i.
DrawList BuildRobotDrawList(const RobotModel& robot);

}  // namespace eod::sim
