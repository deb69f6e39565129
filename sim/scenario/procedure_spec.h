#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace eod::sim {

class TomlTable;

/// An item of the check list: done once, in the order of the list, or kept all the time.
struct ProcedureSpec {
  enum class Kind : uint8_t {
    // Done once.
    kEstopTest,          ///< e-stop latched and left again, before or during the mission
    kLampTest,           ///< before or during the mission
    kCameraTour,         ///< looked through each of the four cameras
    kTwoCameraRecon,     ///< looked through two cameras since the start, and then the first grasp
    kHornBeforeFire,     ///< the horn was sounded, and then the first shot fired
    kRetreatBeforeFire,  ///< the first shot fired from at least `distance` from the charge
    // Kept all the time.
    kLowSpeedWhileCarrying,    ///< no driving at high speed with a charge in the hand
    kTravelPoseBeforeDriving,  ///< a charge is drawn in before it is driven farther than a little
    kArmKeySafeUntilStill,     ///< the arm key is never armed while the robot drives
  };
  Kind kind = Kind::kEstopTest;
  std::string text;     ///< for the report; "" for the usual words
  int before_step = 0;  ///< has to be done before this step is complete (1: the first); 0: any time
  double distance = 0;  ///< [m]
};

/// Name of the kind, as in the file.
std::string_view NameOf(ProcedureSpec::Kind kind);
/// The usual words for it.
std::string_view TextOf(ProcedureSpec::Kind kind);
/// It has no moment of its own: it may not be broken.
bool IsKeptAllTheTime(ProcedureSpec::Kind kind);

/// Reads a [[procedure]]. Throws "FILE:LINE: …".
ProcedureSpec ReadProcedureSpec(const TomlTable& table);

}  // namespace eod::sim
