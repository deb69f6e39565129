#pragma once

#include <cstdint>

#include "platform/can_frame.h"

namespace eod::recorder {

/// How busy the bus is: bits of all frames, worst-case stuffing included, against its bit rate. On
/// a bus without a bit rate (UDP, vcan) it is the load that a real bus would have.
class BusLoad {
 public:
  /// `bit_rate` in bit/s, positive.
  explicit BusLoad(int bit_rate) : bit_rate_(bit_rate) {}

  void Add(const CanFrame& frame);

  /// Mean between the first and the last frame's stamp [percent]; 0 without two frames. Stamps are
  /// taken at a frame's end, so the first frame itself lies outside.
  double percent() const;

 private:
  int bit_rate_;
  int64_t bits_ = 0;  ///< of all frames but the first
  bool any_ = false;
  TimePoint first_{};
  TimePoint last_{};
};

}  // namespace eod::recorder
