#pragma once

#include <cstdint>
#include <optional>

#include "platform/time.h"

namespace eod::bridge {

/// Age and CRC record of one received message.
///
/// Link fault: three wrong CRCs in a row, or five among the last 50 frames.
class FrameWatch {
 public:
  /// A frame was accepted.
  void Accept(TimePoint now);
  /// A frame was dropped although its CRC was right (counter).
  void NoteGoodCrc() { crc_errors_ <<= 1; }
  /// A frame was dropped for its CRC.
  void NoteWrongCrc() { crc_errors_ = crc_errors_ << 1 | 1; }
  bool HasCrcFault() const;
  /// Starts the CRC record anew, as after a reset by the operator.
  void ForgetCrcErrors() { crc_errors_ = 0; }

  bool seen() const { return last_.has_value(); }
  /// True if the last accepted frame is older than `limit`; false if there never was one.
  bool IsOlderThan(Duration limit, TimePoint now) const { return last_ && now - *last_ > limit; }
  /// True if a frame was accepted and is not older than `limit`.
  bool IsFresh(Duration limit, TimePoint now) const { return last_ && now - *last_ <= limit; }
  std::optional<TimePoint> last() const { return last_; }

 private:
  std::optional<TimePoint> last_;
  uint64_t crc_errors_ = 0;  ///< bit 0 is the latest frame, 1 = wrong CRC
};

}  // namespace eod::bridge
