#include <algorithm>
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "platform/candump_log.h"
#include "tests/scenario/mission.h"

namespace eod::lockstep {
namespace {

using namespace std::chrono_literals;

const std::filesystem::path kFirstDrive = kData / "firmware_emu/scripts/first_drive.boxscript";
const std::filesystem::path kWallStop = kData / "firmware_emu/scripts/wall_stop.boxscript";

/// Collision lamp of a ROB_ALARM frame, decoded by the shipped DBC.
class LampReader {
 public:
  std::optional<dbc::LampPattern> Collision(const CanFrame& frame) {
    const auto received = codec_.Decode(frame, feedback_);
    if (received.role != dbc::RobotMessage::kAlarm) return std::nullopt;
    return feedback_.lamp[static_cast<size_t>(dbc::Lamp::kCollision)];
  }

 private:
  dbc::ControlMap map_ = dbc::LoadControlMap(kData / "dbc/control_box.map.toml");
  dbc::BoxCodec codec_{dbc::LoadDatabase(kData / "dbc/control_box.dbc"), map_};
  dbc::RobotFeedback feedback_;
};

TEST(FirstDrive, ReachesTheEndOfTheMissionThroughTheBoxAlone) {
  Mission dut(kFirstDrive);
  std::vector<sim::AlarmCode> raised;
  ASSERT_TRUE(dut.Run(120s));
  EXPECT_EQ(dut.box().script_failure(), std::nullopt);
  const sim::StepResult& last = dut.rig().simulator().last();
  EXPECT_EQ(last.task.state, sim::MissionState::kSuccess);
  EXPECT_EQ(last.task.step, last.task.steps);
  // One collision was asked for (the wall). Points are lost for holding forward there beyond the
  // grace, and for backing off without looking that way; for nothing else.
  EXPECT_EQ(last.task.collisions, 1);
  const sim::ScoreRules& rules = ShippedData().rules.score;
  const sim::ScoreSheet sheet = dut.rig().simulator().scorer().Sheet();
  const double pushed = sheet.parts[1].items[1].amount;
  EXPECT_GT(pushed, 0);
  EXPECT_NEAR(last.task.score, 100 - rules.push_points * pushed - rules.unseen_points, 1e-9);
  EXPECT_TRUE(sheet.passed);
}

TEST(FirstDrive, TwoRunsGiveTheSameBits) {
  Mission first(kFirstDrive);
  Mission second(kFirstDrive);
  ASSERT_TRUE(first.Run(120s));
  ASSERT_TRUE(second.Run(120s));
  EXPECT_GT(first.can_log().size(), 1000u);
  EXPECT_TRUE(first.can_log() == second.can_log());
  EXPECT_TRUE(first.states() == second.states());
}

TEST(FirstDrive, WallStopsTheRobotAndTheLampFollowsWithinAStepAndTwoMilliseconds) {
  Mission dut(kWallStop);
  std::unique_ptr<CanBus> bus = dut.rig().Connect();
  LampReader lamps;
  std::optional<TimePoint> contact;
  std::optional<TimePoint> lamp;
  double y_at_contact = 0;
  dut.rig().SetStepSink([&](const sim::StepResult& step, const sim::AlarmTable&) {
    for (const sim::AlarmChange& change : step.alarm_changes) {
      if (change.code == sim::AlarmCode::kCollision && change.raised && !contact) {
        contact = step.time;
        y_at_contact = step.state.position.y();
      }
    }
  });
  const bool lamp_came = dut.rig().RunUntil(
      [&] {
        while (const auto frame = bus->Receive()) {
          const auto pattern = lamps.Collision(*frame);
          if (pattern && *pattern != dbc::LampPattern::kOff && !lamp) lamp = frame->stamp;
        }
        return lamp.has_value();
      },
      60s);
  ASSERT_TRUE(lamp_came);
  ASSERT_TRUE(contact.has_value());
  EXPECT_GE(*lamp, *contact);
  EXPECT_LE(*lamp - *contact, dut.rig().simulator().last().time - *contact + 2ms);
  EXPECT_LE(*lamp - *contact, 4ms + 2ms);
  // Forward is inhibited, nothing else of the drive is, and the robot does not move on.
  dut.rig().RunFor(200ms);
  const sim::StepResult& last = dut.rig().simulator().last();
  EXPECT_TRUE(sim::Contains(last.inhibited, sim::kDriveForward));
  EXPECT_FALSE(sim::Contains(last.inhibited, sim::kDriveReverse));
  EXPECT_EQ(last.state.position.y(), y_at_contact);
}

TEST(FirstDrive, PulledCableRampsTheRobotToAStandWithinThreeTenthsOfASecond) {
  Mission dut(kData / "firmware_emu/scripts/drive_one_metre.boxscript");
  const auto speed = [&dut] { return dut.rig().simulator().last().speed; };
  ASSERT_TRUE(dut.rig().RunUntil([&] { return speed() > 0.05; }, 30s));
  dut.rig().RunFor(1s);  // up to speed
  const double full = speed();
  dut.rig().UnplugBox();
  // Rule 2: the motion goes on for 100 ms after the last frame (which is up to 20 ms old), and is
  // then ramped to zero within 200 ms.
  dut.rig().RunFor(100ms - 20ms - 4ms);
  EXPECT_EQ(speed(), full);
  dut.rig().RunFor(20ms + 4ms + 100ms);
  EXPECT_GT(speed(), 0.3 * full);
  EXPECT_LT(speed(), 0.7 * full);
  dut.rig().RunFor(100ms + 20ms + 4ms);
  EXPECT_EQ(speed(), 0.0);
}

TEST(FirstDrive, AnotherMakersBoxIsTwoFilesAndNoRebuild) {
  RigConfig config = Mission::ShippedRig();
  config.bridge.dbc_file = kData / "tests/unit/dbc/data/shuffled_box.dbc";
  config.bridge.map_file = kData / "tests/unit/dbc/data/shuffled_box.map.toml";
  Mission other(kWallStop, config);
  Mission shipped(kWallStop);
  ASSERT_TRUE(other.Run(60s));
  ASSERT_TRUE(shipped.Run(60s));
  EXPECT_EQ(other.box().script_failure(), std::nullopt);
  EXPECT_FALSE(other.can_log() == shipped.can_log());
  const sim::StepResult& last = other.rig().simulator().last();
  EXPECT_EQ(last.task.collisions, shipped.rig().simulator().last().task.collisions);
  EXPECT_NEAR(last.state.position.y(), shipped.rig().simulator().last().state.position.y(), 0.03);
}

}  // namespace
}  // namespace eod::lockstep
