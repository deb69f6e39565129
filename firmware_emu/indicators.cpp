#include "firmware_emu/indicators.h"

#include <chrono>

namespace eod::box {

using std::chrono::milliseconds;

namespace {

constexpr Duration kSlowPeriod = milliseconds(1000);
constexpr Duration kFastPeriod = milliseconds(250);
constexpr Duration kBeep = milliseconds(150);
constexpr Duration kFailureTone = milliseconds(1000);

bool IsFirstHalf(Duration time, Duration period) { return time % period < period / 2; }

}  // namespace

bool IsLit(dbc::LampPattern pattern, TimePoint now) {
  switch (pattern) {
    case dbc::LampPattern::kOff:
      return false;
    case dbc::LampPattern::kOn:
      return true;
    case dbc::LampPattern::kSlowBlink:
      return IsFirstHalf(now.time_since_epoch(), kSlowPeriod);
    case dbc::LampPattern::kFastBlink:
      return IsFirstHalf(now.time_since_epoch(), kFastPeriod);
  }
  return false;
}

bool IsSounding(dbc::BuzzerPattern pattern, Duration since_start) {
  switch (pattern) {
    case dbc::BuzzerPattern::kOff:
      return false;
    case dbc::BuzzerPattern::kBeep:
      return since_start < kBeep;
    case dbc::BuzzerPattern::kSlow:
      return IsFirstHalf(since_start, kSlowPeriod);
    case dbc::BuzzerPattern::kFast:
      return IsFirstHalf(since_start, kFastPeriod);
    case dbc::BuzzerPattern::kContinuous:
      return true;
    case dbc::BuzzerPattern::kSuccess:
      return since_start < 3 * kBeep && since_start / kBeep != 1;
    case dbc::BuzzerPattern::kFailure:
      return since_start < kFailureTone;
  }
  return false;
}

}  // namespace eod::box
