#pragma once

#include <string_view>

namespace eod::sim {

/// What the operator's panel shows: numbers of box_command_t.camera_select.
enum class CameraChoice : int { kQuad, kDrive, kGripper, kMast, kRear };

/// Name of the picture that shows all cameras.
inline constexpr std::string_view kQuadPicture = "quad";

/// How often a picture of that name is rendered for a choice: every nth of the full rate, 0 never.
/// Rendering is what costs most, so at most two cameras have the full rate: the chosen one, and the
/// one that an operator wants beside it. That is the mast for drive and for the gripper, whose way
/// to a charge it shows, and drive for the mast and the rear. The quad picture has it alone. What
/// is no choice counts as drive.
int PictureInterval(int choice, std::string_view camera);

}  // namespace eod::sim
