// Cycle times, counters and CRCs as they stand on the bus.
#include <algorithm>
#include <cstdlib>
#include <map>
#include <random>

#include <gtest/gtest.h>

#include "dbc/e2e.h"
#include "tests/unit/firmware_emu/box_rig.h"

namespace eod::box {
namespace {

constexpr Duration kOperational = milliseconds(500);  // boot 100 ms, self-test 400 ms
constexpr int kCrcByte = 0;

struct Cyclic {
  uint32_t id;
  int cycle_ms;
  int offset_ms;
};

// From the DBC's GenMsgCycleTime and the offsets of TransmitSchedule.
constexpr std::array<Cyclic, 5> kProcessData{{{kSafetyId, 20, 0},
                                              {kMotionId, 20, 5},
                                              {kAxesId, 20, 10},
                                              {kFireId, 20, 15},
                                              {kPanelId, 50, 8}}};

// Largest distance of a frame from start + offset + k * cycle, k counting the frames.
Duration MaxDeviation(const std::vector<CanFrame>& frames, const Cyclic& cyclic) {
  Duration worst{};
  for (size_t k = 0; k < frames.size(); ++k) {
    const TimePoint due = At(kOperational + milliseconds(cyclic.offset_ms) +
                             milliseconds(cyclic.cycle_ms) * static_cast<int64_t>(k));
    worst = std::max(worst, std::chrono::abs(frames[k].stamp - due));
  }
  return worst;
}

// Ticks the box over 10 s of operation with the given moments between the ticks.
template <typename NextStep>
void RunWithSteps(BoxRig& rig, NextStep next_step) {
  rig.robot_talks = false;
  const TimePoint end = At(kOperational + seconds(10));
  rig.Tick();
  while (true) {
    rig.now += next_step();
    if (rig.now >= end) return;
    rig.Tick();
  }
}

TEST(CycleTime, IsExactOverTenSeconds) {
  BoxRig rig;
  RunWithSteps(rig, [] { return milliseconds(1); });
  for (const Cyclic& cyclic : kProcessData) {
    const auto frames = rig.SentWithId(cyclic.id);
    EXPECT_EQ(frames.size(), 10000u / cyclic.cycle_ms) << std::hex << cyclic.id;
    EXPECT_EQ(MaxDeviation(frames, cyclic), Duration::zero()) << std::hex << cyclic.id;
  }
  EXPECT_EQ(rig.dut.status().max_late, Duration::zero());
}

TEST(CycleTime, AgreesWithTheDbc) {
  const dbc::Database database = dbc::LoadDatabase(EOD_DATA_DIR "/dbc/control_box.dbc");
  for (const Cyclic& cyclic : kProcessData) {
    EXPECT_EQ(database.FindMessage(cyclic.id, false)->cycle_time_ms(), cyclic.cycle_ms);
  }
}

TEST(CycleTime, JitteryTicksDelayAFrameByTheirJitterAndLoseNone) {
  BoxRig rig;
  std::minstd_rand random(1);
  std::uniform_int_distribution<int> step_us(200, 1000);
  RunWithSteps(rig, [&] { return std::chrono::microseconds(step_us(random)); });
  for (const Cyclic& cyclic : kProcessData) {
    const auto frames = rig.SentWithId(cyclic.id);
    EXPECT_EQ(frames.size(), 10000u / cyclic.cycle_ms) << std::hex << cyclic.id;
    EXPECT_LE(MaxDeviation(frames, cyclic), milliseconds(1)) << std::hex << cyclic.id;
  }
  EXPECT_LE(rig.dut.status().max_late, milliseconds(1));
}

TEST(CycleTime, LateTicksDoNotShiftTheSchedule) {
  BoxRig rig;
  int tick = 0;
  // Every 96th tick comes 13 ms late.
  RunWithSteps(rig, [&] { return milliseconds(++tick % 96 == 0 ? 14 : 1); });
  for (const Cyclic& cyclic : kProcessData) {
    const auto frames = rig.SentWithId(cyclic.id);
    EXPECT_EQ(frames.size(), 10000u / cyclic.cycle_ms) << std::hex << cyclic.id;
    EXPECT_LE(MaxDeviation(frames, cyclic), milliseconds(13)) << std::hex << cyclic.id;
  }
  EXPECT_EQ(rig.dut.status().max_late, milliseconds(13));
  EXPECT_EQ(rig.dut.status().skipped, 0u);
}

TEST(CycleTime, AfterAPauseStaleFramesAreLeftOutAndTheScheduleStands) {
  BoxRig rig;
  rig.PowerUp();
  rig.sent.clear();
  rig.now =
      At(milliseconds(583));  // nothing since 520: safety of 520 is out, 540 and 560 are stale
  rig.Tick();
  EXPECT_EQ(rig.SentWithId(kSafetyId).size(), 1u);
  rig.Run(milliseconds(40));
  const auto frames = rig.SentWithId(kSafetyId);
  ASSERT_EQ(frames.size(), 3u);
  EXPECT_EQ(frames[1].stamp, At(milliseconds(600)));
  EXPECT_EQ(frames[2].stamp, At(milliseconds(620)));
  // Due and never sent: safety 540, 560; motion 525, 545; axes 530, 550; fire 535, 555.
  EXPECT_EQ(rig.dut.status().skipped, 8u);
}

TEST(CycleTime, FramesOfOneCycleDoNotStandInOneTick) {
  BoxRig rig;
  RunWithSteps(rig, [] { return milliseconds(1); });
  std::map<TimePoint, int> per_tick;
  for (const CanFrame& frame : rig.sent) ++per_tick[frame.stamp];
  for (const auto& [time, count] : per_tick) EXPECT_EQ(count, 1) << ToUtime(time);
}

TEST(Heartbeat, BootsUpThenPreOperationalThenOperational) {
  BoxRig rig;
  rig.Tick();
  rig.Run(milliseconds(1200));
  const auto frames = rig.SentWithId(kHeartbeatId);
  // Boot-up at 100 ms; then every 200 ms from 113 ms on; operational from 500 ms on.
  ASSERT_EQ(frames.size(), 7u);
  const std::array<int, 7> expected_ms{100, 113, 313, 513, 713, 913, 1113};
  const std::array<int, 7> expected_state{0, 127, 127, 5, 5, 5, 5};
  for (size_t i = 0; i < frames.size(); ++i) {
    EXPECT_EQ(frames[i].stamp, At(milliseconds(expected_ms[i])));
    EXPECT_EQ(frames[i].data[0], expected_state[i]);
    EXPECT_EQ(frames[i].length, 1);
  }
}

TEST(EndToEnd, CountersRunWithoutAGapAndCrcsAreRight) {
  BoxRig rig;
  int ms = 0;
  // The e-stop is played with, so that event frames come between the cyclic ones.
  RunWithSteps(rig, [&] {
    rig.inputs.estop_pressed = ++ms % 333 > 300;
    return milliseconds(1);
  });
  for (const Cyclic& cyclic : kProcessData) {
    int expected_counter = 0;
    for (const CanFrame& frame : rig.SentWithId(cyclic.id)) {
      const auto data_id = static_cast<uint16_t>(cyclic.id);
      EXPECT_EQ(frame.data[kCrcByte], dbc::E2eCrc(data_id, frame.payload(), kCrcByte));
      EXPECT_EQ(frame.data[1] & 0x0F, expected_counter);
      expected_counter = (expected_counter + 1) % dbc::kE2eCounterCount;
    }
  }
  EXPECT_GT(rig.SentWithId(kSafetyId).size(), 510u);
}

TEST(SafetyEvent, EstopIsOnTheBusInTheTickOfItsEdge) {
  BoxRig rig;
  rig.PowerUp();
  rig.Run(milliseconds(3));  // between two cyclic safety frames
  rig.sent.clear();
  rig.inputs.estop_pressed = true;
  rig.Run(milliseconds(1));
  const auto frames = rig.SentWithId(kSafetyId);
  ASSERT_EQ(frames.size(), 1u);
  EXPECT_EQ(frames[0].data[2] & 0x03, 0x02);  // A = 0, B = 1: pressed
}

TEST(SafetyEvent, LettingGoOfTheEnablingSwitchIsOnTheBusAtOnceAndHoldingItIsNot) {
  BoxRig rig;
  rig.PowerUp();
  rig.Run(milliseconds(1));
  rig.inputs.controls.deadman = dbc::Deadman::kEnabled;
  rig.Run(milliseconds(28));  // to 549: believed since 532, told with the cyclic frame of 540
  EXPECT_EQ(rig.SentWithId(kSafetyId).back().stamp, At(milliseconds(540)));
  rig.inputs.controls.deadman = dbc::Deadman::kReleased;
  rig.Run(milliseconds(1));
  EXPECT_EQ(rig.SentWithId(kSafetyId).back().stamp, At(milliseconds(550)));
}

TEST(SafetyEvent, AMotionButtonWaitsForTheNextCyclicFrame) {
  BoxRig rig;
  rig.PowerUp();
  rig.sent.clear();
  rig.inputs.controls.motion[0] = true;
  rig.Run(milliseconds(60));
  // Believed at 531, so first in the motion frame of 545.
  for (const CanFrame& frame : rig.SentWithId(kMotionId)) {
    EXPECT_EQ(frame.data[2] & 1, frame.stamp >= At(milliseconds(545)) ? 1 : 0);
  }
  EXPECT_EQ(rig.SentWithId(kMotionId).size(), 3u);
}

}  // namespace
}  // namespace eod::box
