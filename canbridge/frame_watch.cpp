#include "canbridge/frame_watch.h"

#include <bit>

namespace eod::bridge {
namespace {

constexpr uint64_t kThreeInARow = 0b111;
constexpr int kErrorsInWindow = 5;
constexpr uint64_t kWindow = (uint64_t{1} << 50) - 1;  // the last 50 frames

}  // namespace

void FrameWatch::Accept(TimePoint now) {
  last_ = now;
  NoteGoodCrc();
}

bool FrameWatch::HasCrcFault() const {
  return (crc_errors_ & kThreeInARow) == kThreeInARow ||
         std::popcount(crc_errors_ & kWindow) >= kErrorsInWindow;
}

}  // namespace eod::bridge
