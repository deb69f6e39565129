#include "sim/sim_node.h"

#include <cmath>
#include <numbers>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <lcm/lcm-cpp.hpp>

#include "eod/image_t.hpp"

#include "lcmtypes/channels.h"
#include "platform/clock.h"
#include "sim/picture_node.h"
#include "tests/unit/behaviour/operator.h"

namespace eod::sim {
namespace {

using std::chrono::milliseconds;

/// Keeps every message of one channel.
template <typename Message>
class Inbox {
 public:
  Inbox(lcm::LCM& lcm, const std::string& channel) {
    lcm.subscribe(channel, &Inbox::OnMessage, this);
  }
  std::vector<Message> messages;

 private:
  void OnMessage(const lcm::ReceiveBuffer*, const std::string&, const Message* message) {
    messages.push_back(*message);
  }
};

/// The node on LCM within this process, in virtual time, with somebody who listens and commands.
class SimNodeTest : public ::testing::Test {
 protected:
  static constexpr char kPrefix[] = "T_";

  explicit SimNodeTest(SimNodeConfig config = {.channel_prefix = kPrefix})
      : config_(std::move(config)) {
    config_.simulator = WithRules(config_.simulator);
  }

  void SetUp() override {
    dut_ =
        std::make_unique<SimNode>(config_, TheSharpRobot(), TheWorld(), FirstDrive(), lcm_, clock_);
    command_.motion_permitted = 1;
    command_.speed_range = 1;
  }

  static std::string Name(const Channel& channel) { return ChannelName(kPrefix, channel); }

  void Tick(int times = 1) {
    for (int i = 0; i < times; ++i) {
      clock_.Advance(milliseconds(4));
      dut_->OnTick(clock_.Now());
      while (lcm_.handleTimeout(0) > 0) {
      }
    }
  }
  void Command(std::initializer_list<int> motions, int ticks) {
    for (double& rate : command_.motion_rate) rate = 0;
    for (const int motion : motions) command_.motion_rate[motion] = 1;
    for (int i = 0; i < ticks; ++i) {
      ++command_.sequence;
      lcm_.publish(Name(kBoxCommandChannel), &command_);
      while (lcm_.handleTimeout(0) > 0) {
      }
      Tick();
    }
  }

  SimNodeConfig config_;
  lcm::LCM lcm_{"memq://"};
  ManualClock clock_{TimePoint{std::chrono::seconds(1000)}};
  std::unique_ptr<SimNode> dut_;
  box_command_t command_{};
};

TEST_F(SimNodeTest, MissedStepsAreMadeUpForOneATickSoThatTimeStaysTrue) {
  Inbox<robot_state_t> states(lcm_, Name(kRobotStateChannel));
  Tick(2);
  clock_.Advance(milliseconds(12));  // three ticks that never came
  Tick(1);
  ASSERT_EQ(states.messages.size(), 4u);  // two, then two at once
  EXPECT_EQ(states.messages.back().overruns, 3);
  Tick(2);
  ASSERT_EQ(states.messages.size(), 8u);
  Tick(1);
  ASSERT_EQ(states.messages.size(), 9u);  // the debt is paid: 2 + 3 + 1 + 3 periods passed
  EXPECT_EQ(states.messages.back().utime, ToUtime(clock_.Now()));
  for (size_t i = 1; i < states.messages.size(); ++i) {
    EXPECT_EQ(states.messages[i].utime - states.messages[i - 1].utime, 4000);
    EXPECT_EQ(states.messages[i].step - states.messages[i - 1].step, 1);
  }
}

TEST_F(SimNodeTest, ALongPauseIsLeftOutAndCounted) {
  Inbox<robot_state_t> states(lcm_, Name(kRobotStateChannel));
  Tick(1);
  clock_.Advance(milliseconds(400));  // a hundred ticks that never came
  Tick(2);
  ASSERT_EQ(states.messages.size(), 3u);
  EXPECT_EQ(states.messages.back().overruns, 100);
  EXPECT_EQ(states.messages.back().utime, ToUtime(clock_.Now()));
}

TEST_F(SimNodeTest, StatePublishedEveryStepCarriesTheScheduledTimeAndWorldPose) {
  Inbox<robot_state_t> states(lcm_, Name(kRobotStateChannel));
  Command({kDriveForward}, 10);
  ASSERT_EQ(states.messages.size(), 10u);
  const robot_state_t& state = states.messages.back();
  EXPECT_EQ(state.utime, 1000'040'000);
  EXPECT_EQ(state.step, 10);
  EXPECT_EQ(state.module, 1);
  // Start pad of module flat in W, and ten steps of 1.2 mm to the north.
  EXPECT_NEAR(state.position_m[0], TheWorld().Module(1).p_WM.x(), 1e-9);
  EXPECT_NEAR(state.position_m[1], TheWorld().Module(1).p_WM.y() + 0.012, 1e-9);
  EXPECT_NEAR(state.joint[kFrontFlipper], 90, 1e-9);
  EXPECT_NEAR(state.speed_mps, 0.30, 1e-12);
  EXPECT_EQ(state.command_sequence, 10);
}

TEST_F(SimNodeTest, AlarmChangesAreToldAtOnceAndTheSetIsRepeated) {
  Inbox<alarm_t> alarms(lcm_, Name(kAlarmChannel));
  Inbox<robot_state_t> states(lcm_, Name(kRobotStateChannel));
  Command({kDriveForward}, 3200);  // at the wall after 3.475 m, 2896 steps
  size_t changes = 0;
  for (size_t i = 0; i < alarms.messages.size(); ++i) {
    const alarm_t& alarm = alarms.messages[i];
    EXPECT_EQ(alarm.source, alarm_t::SOURCE_SIM);
    EXPECT_EQ(alarm.num_active, static_cast<int>(alarm.active_code.size()));
    if (i > 0) {
      EXPECT_LE(alarm.utime - alarms.messages[i - 1].utime, 100'000);
    }
    if (alarm.is_repeat) continue;
    ++changes;
    if (changes > 1) continue;  // the push after the alarm comes later
    EXPECT_EQ(alarm.code, 0x10);
    EXPECT_TRUE(alarm.raised);
    EXPECT_EQ(alarm.parts, 1 << static_cast<int>(Part::kChassis));
    EXPECT_EQ(alarm.active_code, std::vector<int16_t>{0x10});
    // The alarm belongs to the step whose state first shows the contact.
    const auto first = std::find_if(states.messages.begin(), states.messages.end(),
                                    [](const auto& state) { return state.contact_parts != 0; });
    ASSERT_NE(first, states.messages.end());
    EXPECT_EQ(alarm.utime, first->utime);
  }
  EXPECT_EQ(changes, 2u);
}

TEST_F(SimNodeTest, TheSceneIsToldAtOnceAndEvery100MillisecondsInTheModulesFrame) {
  Inbox<scene_t> scenes(lcm_, Name(kSceneChannel));
  Tick(1);
  ASSERT_EQ(scenes.messages.size(), 1u);
  Tick(25);
  ASSERT_EQ(scenes.messages.size(), 2u);
  const scene_t& scene = scenes.messages.back();
  EXPECT_EQ(scene.utime - scenes.messages.front().utime, 100000);
  const ModuleModel& module = dut_->simulator().module();
  EXPECT_EQ(scene.module, module.id);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(scene.origin_m[i], module.p_WM[i]);
  const size_t movables = module.movables.size();
  ASSERT_EQ(scene.name.size(), movables + module.objects.size());
  for (size_t i = 0; i < scene.name.size(); ++i) {
    EXPECT_EQ(scene.is_movable[i] != 0, i < movables) << scene.name[i];
  }
  for (size_t i = 0; i < module.objects.size(); ++i) {
    const WorldObject& fixed = module.objects[i];
    EXPECT_EQ(scene.name[movables + i], fixed.name);
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_EQ(scene.position_m[movables + i][axis], fixed.X_MO.translation()[axis]);
    }
    const double heading = ToAttitude(fixed.X_MO.linear()).heading * (180 / std::numbers::pi);
    EXPECT_NEAR(std::remainder(scene.heading_deg[movables + i] - heading, 360), 0, 1e-9);
  }
}

TEST_F(SimNodeTest, TheSceneFollowsTheModuleTheMenuEnters) {
  Inbox<scene_t> scenes(lcm_, Name(kSceneChannel));
  Tick(3);
  command_.menu_module = 3;
  command_.menu_command = kMenuStart;
  Command({}, 1);
  ASSERT_EQ(scenes.messages.size(), 2u);
  const scene_t& scene = scenes.messages.back();
  EXPECT_EQ(scene.module, 3);
  const auto& movables = dut_->simulator().module().movables;
  ASSERT_FALSE(movables.empty());
  for (size_t i = 0; i < movables.size(); ++i) {
    EXPECT_EQ(scene.name[i], movables[i].name);
    EXPECT_NEAR(scene.tilt_deg[i], 0, 0.1);
    const Eigen::Vector3d centre = movables[i].X_MO * movables[i].p_OC;
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(scene.position_m[i][axis], centre[axis], 1e-3);
    }
  }
}

TEST_F(SimNodeTest, MissionIsToldOnChangeAndEvery200Milliseconds) {
  Inbox<mission_status_t> missions(lcm_, Name(kMissionStatusChannel));
  Tick(100);
  EXPECT_EQ(missions.messages.size(), 2u);  // at 4 ms and at 204 ms
  command_.menu_module = 1;
  command_.menu_command = kMenuStart;
  Command({}, 1);
  ASSERT_EQ(missions.messages.size(), 3u);
  EXPECT_EQ(missions.messages.back().state, mission_status_t::STATE_RUN);
  EXPECT_EQ(missions.messages.back().scenario, "flat_first_drive");
  EXPECT_EQ(missions.messages.back().steps, 4);
  EXPECT_EQ(missions.messages.back().step_text, "Drive forward until the wall stops you");
}

TEST_F(SimNodeTest, InstructorLoadsAnExerciseOnceAndItIsTold) {
  Inbox<mission_status_t> missions(lcm_, Name(kMissionStatusChannel));
  Tick();
  instructor_command_t order{};
  order.sequence = 1;
  order.scenario = FirstDrive().name;
  order.repetition = 3;
  order.menu_command = kMenuStart;
  lcm_.publish(Name(kInstructorChannel), &order);
  Tick(2);
  ASSERT_FALSE(missions.messages.empty());
  EXPECT_EQ(missions.messages.back().state, mission_status_t::STATE_RUN);
  EXPECT_EQ(missions.messages.back().scenario, FirstDrive().name);
  EXPECT_EQ(missions.messages.back().title, FirstDrive().title);
  EXPECT_EQ(missions.messages.back().difficulty, FirstDrive().difficulty);
  EXPECT_EQ(missions.messages.back().repetition, 3);
  Tick(100);
  lcm_.publish(Name(kInstructorChannel), &order);  // the same once more
  Tick(60);
  EXPECT_GT(missions.messages.back().elapsed_s, 0.5) << "it was not started over";
  order.estop = 1;
  lcm_.publish(Name(kInstructorChannel), &order);
  Tick(2);
  EXPECT_EQ(missions.messages.back().state, mission_status_t::STATE_FAIL);
  EXPECT_EQ(missions.messages.back().fail_reason, static_cast<int>(FailReason::kEstop));
}

TEST_F(SimNodeTest, NewestCommandWinsAndItsAgeCountsFromItsArrival) {
  Inbox<robot_state_t> states(lcm_, Name(kRobotStateChannel));
  Command({kDriveForward}, 1);
  // Arrived 4 ms before the first step: the last step that obeys is at 96 ms of age.
  Tick(40);
  int moving = 0;
  for (const robot_state_t& state : states.messages) moving += state.speed_mps > 0 ? 1 : 0;
  EXPECT_EQ(moving, 24);
}

TEST_F(SimNodeTest, ScenesAreShownAtTheCamerasRateNotAtTheStepsRate) {
  std::vector<SceneSnapshot> scenes;
  dut_->SetSceneOutput({.show = [&](const SceneSnapshot& scene) { scenes.push_back(scene); },
                        .period = milliseconds(40),
                        .draw_isectors = true});
  Command({kDriveForward}, 250);  // 1 s
  EXPECT_EQ(scenes.size(), 25u);
  EXPECT_EQ(scenes[1].time - scenes[0].time, milliseconds(40));
  EXPECT_GT(scenes.back().state.position.y(), 0.2);
  // Drawn are the segments that the motion loaded, in the colour of what they met.
  const auto segments = dut_->simulator().isectors().segments();
  ASSERT_EQ(scenes.back().segments.size(), segments.size());
  for (size_t i = 0; i < segments.size(); ++i) {
    EXPECT_EQ(scenes.back().segments[i].hit, segments[i].hit.hit);
  }
}

TEST_F(SimNodeTest, ScenesCarryTheOperatorsCamera) {
  std::vector<SceneSnapshot> scenes;
  dut_->SetSceneOutput({.show = [&](const SceneSnapshot& scene) { scenes.push_back(scene); },
                        .period = milliseconds(4)});
  Tick(1);
  EXPECT_EQ(scenes.back().camera_select, 1) << "drive before anything was heard";
  command_.camera_select = 2;
  Command({}, 2);
  EXPECT_EQ(scenes.back().camera_select, 2);
}

class IsectorNodeTest : public SimNodeTest {
 protected:
  IsectorNodeTest() : SimNodeTest({.channel_prefix = kPrefix, .publish_isectors = true}) {}
};

TEST_F(IsectorNodeTest, HitsAreInTheWorldFrame) {
  Inbox<isector_hits_t> hits(lcm_, Name(kIsectorHitsChannel));
  Tick();
  ASSERT_EQ(hits.messages.size(), 1u);
  const isector_hits_t& message = hits.messages[0];
  const auto found = std::find(message.isector.begin(), message.isector.end(), "LOS_FRONT");
  ASSERT_NE(found, message.isector.end());
  const auto i = static_cast<size_t>(found - message.isector.begin());
  // From the chassis front at y = 0.475 to the wall's face at 4.0.
  EXPECT_TRUE(message.hit[i]);
  EXPECT_EQ(message.object[i], "wall");
  EXPECT_NEAR(message.range_m[i], 4.0 - 0.475, 1e-3);
  EXPECT_NEAR(message.start_m[i][1], TheWorld().Module(1).p_WM.y() + 0.475, 1e-9);
  const Eigen::Vector3d p_WH = TheWorld().Module(1).p_WM + Eigen::Vector3d(0, 4.0, 0.30);
  EXPECT_LT((Eigen::Vector3d(message.point_m[i].data()) - p_WH).norm(), 1e-3);
  EXPECT_LT((Eigen::Vector3d(message.normal[i].data()) + Eigen::Vector3d::UnitY()).norm(), 1e-9);
}

TEST_F(IsectorNodeTest, HitsTellWhatWasMetAndByWhichMethod) {
  Inbox<isector_hits_t> hits(lcm_, Name(kIsectorHitsChannel));
  Tick();
  const isector_hits_t& message = hits.messages.at(0);
  for (int i = 0; i < message.num_segments; ++i) {
    const bool stands = message.isector[i] == "TRIPOD";
    EXPECT_EQ(message.method[i], stands ? "tripod" : "los");
    ASSERT_TRUE(message.hit[i]);
    const auto object_class = static_cast<uint32_t>(message.object_class[i]);
    EXPECT_TRUE(Accepts(kModuleFlat | (stands ? kClampProxy : kBumpProxy), object_class));
    const auto& triangles = TheWorld().Module(1).triangles;
    ASSERT_LT(static_cast<size_t>(message.triangle[i]), triangles.size());
    EXPECT_EQ(TheWorld().Module(1).objects[triangles[message.triangle[i]].object].name,
              message.object[i]);
  }
}

TEST_F(IsectorNodeTest, WithoutAHitThereIsNoPointAndNoObject) {
  Inbox<isector_hits_t> hits(lcm_, Name(kIsectorHitsChannel));
  Command({kBigArmUp}, 1);  // feelers of the hand, far from everything
  const isector_hits_t& message = hits.messages.at(0);
  const auto found = std::find(message.isector.begin(), message.isector.end(), "B7");
  ASSERT_NE(found, message.isector.end());
  const auto i = static_cast<size_t>(found - message.isector.begin());
  EXPECT_EQ(message.method[i], "bump");
  EXPECT_FALSE(message.hit[i]);
  EXPECT_TRUE(std::isnan(message.range_m[i]));
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_TRUE(std::isnan(message.point_m[i][axis]));
    EXPECT_TRUE(std::isnan(message.normal[i][axis]));
  }
  EXPECT_EQ(message.object[i], "");
  EXPECT_EQ(message.object_class[i], 0);
  EXPECT_EQ(message.triangle[i], -1);
}

TEST_F(IsectorNodeTest, ActiveIsectorsAloneArePublished) {
  Inbox<isector_hits_t> hits(lcm_, Name(kIsectorHitsChannel));
  Tick();
  Command({kDriveReverse}, 1);
  const auto has = [&](size_t step, const char* name) {
    const auto& names = hits.messages.at(step).isector;
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  EXPECT_FALSE(has(0, "B3"));
  EXPECT_TRUE(has(1, "B3"));
  EXPECT_FALSE(has(1, "B1"));
}

TEST(PictureNode, PublishesJpegOnTheCamerasChannel) {
  lcm::LCM lcm("memq://");
  Inbox<image_t> images(lcm, "T_EOD_CAMERA_MAST");
  PictureNode dut(lcm, "T_");
  const std::vector<uint8_t> jpeg = {0xFF, 0xD8, 0xFF, 0xD9};
  dut.Publish({.camera = "mast",
               .time = TimePoint{milliseconds(8)},
               .width = 320,
               .height = 240,
               .jpeg = jpeg});
  dut.Publish({.camera = "nobody's", .time = {}, .width = 1, .height = 1, .jpeg = jpeg});
  while (lcm.handleTimeout(0) > 0) {
  }
  ASSERT_EQ(images.messages.size(), 1u);
  EXPECT_EQ(images.messages[0].utime, 8000);
  EXPECT_EQ(images.messages[0].width, 320);
  EXPECT_EQ(images.messages[0].pixelformat, image_t::PIXEL_FORMAT_MJPEG);
  EXPECT_EQ(images.messages[0].data, jpeg);
}

}  // namespace
}  // namespace eod::sim
