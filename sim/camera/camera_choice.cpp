#include "sim/camera/camera_choice.h"

#include <array>

namespace eod::sim {
namespace {

struct Pair {
  CameraChoice choice;
  std::string_view chosen;
  std::string_view beside;
};

constexpr std::array<Pair, 4> kPairs{{{CameraChoice::kDrive, "drive", "mast"},
                                      {CameraChoice::kGripper, "gripper", "mast"},
                                      {CameraChoice::kMast, "mast", "drive"},
                                      {CameraChoice::kRear, "rear", "drive"}}};

}  // namespace

int PictureInterval(int choice, std::string_view camera) {
  const bool is_quad = choice == static_cast<int>(CameraChoice::kQuad);
  if (is_quad || camera == kQuadPicture) return is_quad && camera == kQuadPicture ? 1 : 0;
  const Pair* shown = kPairs.data();
  for (const Pair& pair : kPairs) {
    if (choice == static_cast<int>(pair.choice)) shown = &pair;
  }
  return camera == shown->chosen || camera == shown->beside ? 1 : 0;
}

}  // namespace eod::sim
