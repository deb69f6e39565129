#pragma once

#include <memory>

#include <gtest/gtest.h>

#include "tests/unit/camera/fixture_scene.h"
#include "tests/unit/camera/offline_camera.h"

namespace eod::sim {

inline constexpr int kWidth = 320;
inline constexpr int kHeight = 240;

/// The fixture's world and robot, rendered small. Painting the textures takes most of the time, so
/// the tests of a suite that leave the world as it is share one renderer.
class FixtureCamera : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    robot_ = std::make_unique<RobotModel>(FixtureRobot());
    world_ = std::make_unique<WorldModel>(FixtureWorld());
    dut_ = std::make_unique<OfflineCamera>(*robot_, *world_, kWidth, kHeight);
  }
  static void TearDownTestSuite() {
    dut_.reset();
    world_.reset();
    robot_.reset();
  }

  static inline std::unique_ptr<RobotModel> robot_;
  static inline std::unique_ptr<WorldModel> world_;
  static inline std::unique_ptr<OfflineCamera> dut_;
};

}  // namespace eod::sim
