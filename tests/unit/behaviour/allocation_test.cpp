#include <gtest/gtest.h>

#include "tests/unit/behaviour/operator.h"
#include "tests/unit/counting_new.h"

namespace eod::sim {
namespace {

TEST(Simulator, StepsAllocateNothingFromTheFirstOn) {
  Operator op;
  const long before = AllocationCount();
  op.command.menu_module = 1;
  op.command.menu_command = kMenuStart;
  op.LevelFlippers();
  op.DriveIntoContact();
  op.Hold({kDriveReverse}, 500);
  op.Hold({kTurnLeft, kBigArmDown, kSmallArmUp, kWristUp, kGripperOpen, kFrontFlipperDown}, 2000);
  op.Hold({kCameraPanLeft, kGripperClose, kDriveForward, kTurnRight}, 2000);
  EXPECT_EQ(AllocationCount() - before, 0);
  EXPECT_GT(before, 0);  // the counter is in place
}

}  // namespace
}  // namespace eod::sim
