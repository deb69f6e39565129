#include "firmware_emu/script_runner.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/firmware_emu/box_rig.h"

namespace eod::box {
namespace {

class Runner : public testing::Test {
 protected:
  void Play(std::string_view text) {
    dut_.emplace(ParseScript(text, "a.boxscript"));
    Run(0);
  }
  // Ticks `ms` more milliseconds, one tick now.
  void Run(int ms) {
    for (int i = 0; i <= ms; ++i) {
      if (i > 0) now_ += milliseconds(1);
      if (now_.time_since_epoch() % milliseconds(50) == Duration::zero()) status_.pose_time = now_;
      dut_->Tick(now_, status_, sight_, hands_);
      hands_.Tick(now_);
    }
  }
  bool IsPressed(int motion) const { return hands_.inputs().controls.motion[motion - 1]; }

  TimePoint now_ = At(seconds(5));
  PanelStatus status_;
  Sight sight_;
  OperatorHands hands_;
  std::optional<ScriptRunner> dut_;
};

TEST_F(Runner, DoesActionsWithoutTimeInOneTick) {
  Play("key operate\nspeed high\npress M01\nnote \"go\"");
  EXPECT_TRUE(dut_->is_done());
  EXPECT_EQ(hands_.inputs().controls.speed_range, dbc::SpeedRange::kHigh);
  EXPECT_TRUE(IsPressed(1));
  EXPECT_EQ(dut_->TakeNotes(), std::vector<std::string>{"go"});
  EXPECT_TRUE(dut_->TakeNotes().empty());
}

TEST_F(Runner, AnEmptyScriptIsDone) {
  Play("# nothing\n");
  EXPECT_TRUE(dut_->is_done());
  EXPECT_FALSE(dut_->failure());
  EXPECT_EQ(dut_->current_line(), "");
}

TEST_F(Runner, WaitTakesItsTime) {
  Play("wait 250ms\nkey operate");
  EXPECT_EQ(dut_->current_line(), "wait 250ms");
  Run(249);
  EXPECT_FALSE(dut_->is_done());
  Run(1);
  EXPECT_TRUE(dut_->is_done());
}

TEST_F(Runner, HoldForPressesSeveralMotionsAndLetsGo) {
  Play("hold M06 M08 for 100ms");
  EXPECT_TRUE(IsPressed(6));
  EXPECT_TRUE(IsPressed(8));
  Run(99);
  EXPECT_TRUE(IsPressed(6));
  Run(1);
  EXPECT_FALSE(IsPressed(6));
  EXPECT_FALSE(IsPressed(8));
}

TEST_F(Runner, TwoHoldsOfOneMotionKeepTheButtonDownInBetween) {
  Play("hold M01 for 50ms\nspeed low\nhold M01 for 50ms");
  for (int ms = 0; ms < 99; ++ms) {
    EXPECT_TRUE(IsPressed(1)) << ms;
    Run(1);
  }
  Run(1);
  EXPECT_FALSE(IsPressed(1));
}

TEST_F(Runner, HoldUntilEndsWithItsCondition) {
  Play("hold M03 until heading >= 88 within 10s");
  Run(1000);
  EXPECT_TRUE(IsPressed(3));
  status_.feedback.heading_deg = 89;
  Run(1);
  EXPECT_FALSE(IsPressed(3));
  EXPECT_TRUE(dut_->is_done());
  EXPECT_FALSE(dut_->failure());
}

TEST_F(Runner, HoldUntilCountsTravelFromItsOwnBegin) {
  status_.feedback.speed_mps = 0.5;
  Play("wait 3s\nhold M01 until travel >= 1 within 10s");
  Run(3000);
  Run(1998);
  EXPECT_FALSE(dut_->is_done());
  Run(4);
  EXPECT_TRUE(dut_->is_done());
}

TEST_F(Runner, HoldPresetRequestsItAndLetsItGo) {
  Play("hold preset carry for 100ms\nkey operate");
  EXPECT_EQ(hands_.inputs().controls.preset, 4);
  Run(99);
  EXPECT_EQ(hands_.inputs().controls.preset, 4);
  Run(1);
  EXPECT_EQ(hands_.inputs().controls.preset, 0);
  EXPECT_TRUE(dut_->is_done());
}

TEST_F(Runner, HoldPresetUntilEndsWithItsConditionAndTwoInARowKeepTheRequest) {
  Play("hold preset stow until joint 3 >= 100 within 5s\nhold preset stow for 50ms");
  Run(1000);
  EXPECT_EQ(hands_.inputs().controls.preset, 1);
  status_.feedback.joint[2] = 100;
  Run(1);
  EXPECT_EQ(hands_.inputs().controls.preset, 1) << "the second line";
  Run(50);
  EXPECT_EQ(hands_.inputs().controls.preset, 0);
}

TEST_F(Runner, FailureLetsGoOfThePreset) {
  Play("hold preset carry until grasp grasped within 1s");
  Run(1000);
  EXPECT_EQ(dut_->failure(),
            "a.boxscript:1: hold preset carry until grasp grasped within 1s: time is up: grasp is "
            "open");
  EXPECT_EQ(hands_.inputs().controls.preset, 0);
}

TEST_F(Runner, WaitUntilGoesOnWhenTheConditionComes) {
  Play("wait lamp estop on within 1s");
  Run(500);
  EXPECT_FALSE(dut_->is_done());
  status_.lamp[static_cast<size_t>(dbc::Lamp::kEstop)] = dbc::LampPattern::kOn;
  Run(1);
  EXPECT_TRUE(dut_->is_done());
  EXPECT_FALSE(dut_->failure());
}

TEST_F(Runner, AConditionThatDoesNotComeInTimeFailsWithFileLineAndObservation) {
  Play("deadman enabled\npress M01\nstick arm_y 20%\n\nwait lamp estop on within 1s\nkey off");
  Run(999);
  EXPECT_FALSE(dut_->failure());
  Run(1);
  EXPECT_TRUE(dut_->is_done());
  EXPECT_EQ(dut_->failure(),
            "a.boxscript:5: wait lamp estop on within 1s: time is up: lamp estop is off");
}

TEST_F(Runner, FailureLetsGoOfMotionsSticksAndEnablingSwitch) {
  Play("deadman enabled\npress M01\nstick arm_y 20%\nexpect link up");
  EXPECT_FALSE(IsPressed(1));
  EXPECT_EQ(hands_.inputs().controls.axis[2].value, 0);
  EXPECT_EQ(hands_.inputs().controls.deadman, dbc::Deadman::kReleased);
}

TEST_F(Runner, ExpectFailsAtOnceAndNothingMoreIsDone) {
  Play("expect link up\nkey operate");
  EXPECT_EQ(dut_->failure(), "a.boxscript:1: expect link up: link is down");
  Run(100);
  EXPECT_EQ(hands_.inputs().controls.key, dbc::KeySwitch::kOff);
}

TEST_F(Runner, FailSaysWhy) {
  Play("fail \"no reason\"");
  EXPECT_EQ(dut_->failure(), "a.boxscript:1: fail \"no reason\": no reason");
}

TEST_F(Runner, TapsEndBeforeTheNextLine) {
  Play("reset\nstart");
  EXPECT_EQ(hands_.inputs().controls.reset, dbc::Button::kPressed);
  EXPECT_EQ(hands_.inputs().controls.start, dbc::Button::kReleased);
  Run(200);
  EXPECT_EQ(hands_.inputs().controls.reset, dbc::Button::kReleased);
  EXPECT_EQ(hands_.inputs().controls.start, dbc::Button::kReleased);
  Run(100);
  EXPECT_EQ(hands_.inputs().controls.start, dbc::Button::kPressed);
}

TEST_F(Runner, ZeroWaitAndZeroWithinAreAllowed) {
  Play("wait 0s\nwait link down within 0s\nkey operate");
  EXPECT_TRUE(dut_->is_done());
  EXPECT_FALSE(dut_->failure());
}

class RunnerByEye : public Runner {
 protected:
  RunnerByEye() {
    sight_.has_robot = true;
    sight_.objects = {{.name = "can", .position = {0, 6, 0.4}}};
  }
  /// What is seen now stays, with the robot at `y` and going at `speed`.
  void See(double y, double speed_mps) {
    sight_.robot_time = sight_.scene_time = now_;
    sight_.position[1] = y;
    sight_.speed_mps = speed_mps;
  }
  void Watch(int ms, double y, double speed_mps = 0) {
    for (int i = 0; i < ms; ++i) {
      See(y, speed_mps);
      Run(1);
    }
  }
};

TEST_F(RunnerByEye, DrivesTowardAPointAndSlowsDownBeforeIt) {
  See(0, 0);
  Play("speed high\ndrive to 0 3");
  Watch(300, 0);
  EXPECT_TRUE(IsPressed(1));
  EXPECT_EQ(hands_.inputs().controls.speed_range, dbc::SpeedRange::kHigh);
  Watch(10, 2.5, 0.67);
  EXPECT_EQ(hands_.inputs().controls.speed_range, dbc::SpeedRange::kLow);
  Watch(10, 2.9, 0.3);
  EXPECT_EQ(hands_.inputs().controls.speed_range, dbc::SpeedRange::kCreep);
  EXPECT_TRUE(IsPressed(1));
  Watch(10, 2.995, 0.1);
  EXPECT_FALSE(IsPressed(1));
  Watch(300, 3.0);
  EXPECT_TRUE(dut_->is_done());
  EXPECT_FALSE(dut_->failure());
  EXPECT_EQ(hands_.inputs().controls.speed_range, dbc::SpeedRange::kHigh);
}

TEST_F(RunnerByEye, TurnsTowardTheGoalTheShortWayRound) {
  See(0, 0);
  Play("turn to 300");
  Watch(300, 0);
  EXPECT_TRUE(IsPressed(4));
  EXPECT_FALSE(IsPressed(1));
}

TEST_F(RunnerByEye, RearFirstItReverses) {
  See(0, 0);
  Play("drive to 0 -3 backwards");
  Watch(300, 0);
  EXPECT_TRUE(IsPressed(2));
}

TEST_F(RunnerByEye, WithoutEyesAManoeuvreFails) {
  Play("drive to 0 3");
  Run(499);
  EXPECT_FALSE(dut_->failure());
  Run(1);
  EXPECT_EQ(dut_->failure(),
            "a.boxscript:1: drive to 0 3: the operator sees nothing: no EOD_ROBOT_STATE and "
            "EOD_SCENE on LCM");
}

TEST_F(RunnerByEye, LetsGoWhenSightIsLost) {
  See(0, 0);
  Play("drive to 0 3");
  Watch(300, 0);
  ASSERT_TRUE(IsPressed(1));
  Run(501);
  EXPECT_FALSE(IsPressed(1));
  EXPECT_FALSE(dut_->failure());
  Run(500);
  EXPECT_TRUE(dut_->failure());
}

TEST_F(RunnerByEye, AnObjectThatIsNotThereFailsWithWhatIs) {
  See(0, 0);
  Play("approach ghost at 1.2");
  EXPECT_EQ(dut_->failure(),
            "a.boxscript:1: approach ghost at 1.2: 'ghost' is not seen; seen are can");
}

TEST_F(RunnerByEye, TimeThatIsUpSaysWhatIsLeft) {
  See(0, 0);
  Play("drive to 0 3 within 2s");
  Watch(1999, 0);
  EXPECT_FALSE(dut_->failure());
  Watch(1, 0);
  EXPECT_EQ(dut_->failure(),
            "a.boxscript:1: drive to 0 3 within 2s: time is up: 3.000 m and 0.0 deg are left, "
            "inhibit reason is none");
  EXPECT_FALSE(IsPressed(1));
}

}  // namespace
}  // namespace eod::box
