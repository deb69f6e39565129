#pragma once

#include "dbc/robot_feedback.h"
#include "platform/time.h"

namespace eod::box {

/// True while a lamp of this pattern is lit: slow blink 1 Hz, fast blink 4 Hz, half of each period
/// lit. The phase comes from absolute time, so all lamps of a box blink together.
bool IsLit(dbc::LampPattern pattern, TimePoint now);

/// True while the buzzer sounds, `since_start` after its pattern began: beep 150 ms once; slow 1
/// Hz; fast 4 Hz; continuous; success two beeps of 150 ms; failure 1 s once.
bool IsSounding(dbc::BuzzerPattern pattern, Duration since_start);

}  // namespace eod::box
