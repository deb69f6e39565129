#pragma once

#include <string_view>

namespace eod::sim {

/// What the operator's panel shows: numbers of box_command_t.camera_select.
enum class CameraChoice : int { kQuad, kDrive, kGripper, kMast, kRear };

/// How often a camera of that name is rendered for a choice: every nth picture of the full rate, 0
/// never. Rendering is what costs most, so at most two cameras have the full rate: the chosen one,
/// and the one that an operator wants beside it. That is the mast for drive and for the gripper,
/// whose way to a charge it shows, and drive for the mast and the rear. For a quad picture all four
/// have half of the rate. What is no choice counts as drive.
int PictureInterval(int choice, std::string_view camera);

}  // namespace eod::sim
