// Counts every allocation of this program, so it is a program of its own.
#include <atomic>
#include <cstdlib>
#include <new>

#include <gtest/gtest.h>

#include "tests/unit/behaviour/operator.h"

namespace {
std::atomic<long> allocations{0};
}  // namespace

void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  ++allocations;
  const auto align = static_cast<std::size_t>(alignment);
  if (void* memory = std::aligned_alloc(align, (size + align - 1) / align * align)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

namespace eod::sim {
namespace {

TEST(Simulator, StepsAllocateNothingFromTheFirstOn) {
  Operator op;
  const long before = allocations;
  op.command.menu_module = 1;
  op.command.menu_command = kMenuStart;
  op.LevelFlippers();
  op.DriveIntoContact();
  op.Hold({kDriveReverse}, 500);
  op.Hold({kTurnLeft, kBigArmDown, kSmallArmUp, kWristUp, kGripperOpen, kFrontFlipperDown}, 2000);
  op.Hold({kCameraPanLeft, kGripperClose, kDriveForward, kTurnRight}, 2000);
  EXPECT_EQ(allocations - before, 0);
  EXPECT_GT(before, 0);  // the counter is in place
}

}  // namespace
}  // namespace eod::sim
