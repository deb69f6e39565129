#pragma once

#include <cstdint>
#include <string>

namespace eod::sim {

/// A camera that does not do what it should.
struct CameraFault {
  enum class Kind : uint8_t {
    kDead,       ///< black, and the control unit says that there is no signal
    kFrozen,     ///< the picture of the moment in which the fault began stays, its clock too
    kNoisy,      ///< strong noise over the picture
    kWrongLight  ///< the iris is stuck: see `stops`
  };
  std::string camera;  ///< name in the robot file
  Kind kind = Kind::kDead;
  float stops = 2.5F;  ///< of kWrongLight: times two of light each; below 0 it is too dark
  bool operator==(const CameraFault&) const = default;
};

}  // namespace eod::sim
