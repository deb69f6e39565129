// Status to screen and journal.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "firmware_emu/keyboard.h"
#include "firmware_emu/panel_journal.h"
#include "firmware_emu/panel_screen.h"
#include "tests/unit/firmware_emu/box_rig.h"

namespace eod::box {
namespace {

Key Character(char character) { return {.kind = Key::Kind::kCharacter, .character = character}; }

// Visible width of each line: escape sequences take no room.
std::vector<size_t> LineWidths(const std::string& screen) {
  std::vector<size_t> widths(1, 0);
  for (size_t i = 0; i < screen.size(); ++i) {
    if (screen[i] == '\x1b') {
      while (i + 1 < screen.size() && std::isalpha(screen[i]) == 0) ++i;
    } else if (screen[i] == '\n') {
      widths.push_back(0);
    } else if (screen[i] != '\r') {
      ++widths.back();
    }
  }
  return widths;
}

TEST(Screen, FitsInto80By24WithEverythingShown) {
  PanelStatus status;
  status.feedback.inhibit_mask = 0x3FFFFF;
  status.feedback.hit_parts = 0xFFF;
  status.feedback.joint.fill(-179.99);
  status.feedback.inhibit_reason = dbc::InhibitReason::kNeutralNeeded;
  status.reported.motion.fill(true);
  status.lit.fill(true);
  status.rx = 4000000000u;
  status.buzzer = dbc::BuzzerPattern::kContinuous;
  status.is_sounding = true;
  status.feedback.alarm_code = 255;
  const std::string screen = DrawPanel(status, {}, "push_after_alarm");
  EXPECT_NE(screen.find("Alarm 255 push_after_alarm\x1b"), std::string::npos) << "name uncut";
  EXPECT_NE(screen.find("Inhibited M01-M22 (neutral_needed)\x1b"), std::string::npos) << "reason";
  EXPECT_NE(screen.find("tilt -179.99\x1b"), std::string::npos) << "joints uncut";
  const std::vector<size_t> widths = LineWidths(screen);
  EXPECT_LE(widths.size(), static_cast<size_t>(kScreenHeight));
  EXPECT_GE(widths.size(), 20u);
  for (const size_t width : widths) EXPECT_LE(width, static_cast<size_t>(kScreenWidth));
}

TEST(Screen, ShowsTheMissionTheBombAndTheFirePanelUncut) {
  PanelStatus status;
  status.feedback.mission_state = 4;  // fail
  status.feedback.step = status.feedback.steps = 15;
  status.feedback.score = 100;
  status.feedback.elapsed_s = 6553.5;
  status.feedback.collisions = 255;
  status.feedback.fail_reason = 4;  // out of area, the longest word
  status.feedback.bomb_state = 9;
  status.feedback.grasp_state = 3;
  status.feedback.fire_state = 1;
  status.feedback.circuit_continuity = 0b111;
  PanelInputs inputs;
  inputs.estop_pressed = true;
  inputs.controls.key = dbc::KeySwitch::kMaintenance;
  inputs.controls.deadman = dbc::Deadman::kReleased;
  inputs.controls.speed_range = dbc::SpeedRange::kCreep;
  inputs.controls.joint_rate = 0.3;
  inputs.controls.menu_module = dbc::Module::kOutdoor;
  inputs.controls.menu_exercise = 12;
  inputs.controls.camera = dbc::CameraSelect::kGripper;
  inputs.controls.light = 2;
  inputs.controls.preset = 3;
  inputs.controls.arm_key = dbc::FireContact::kOn;
  inputs.controls.circuit = 2;
  inputs.controls.fire_left = dbc::FireContact::kOff;
  inputs.controls.fire_right = dbc::FireContact::kOn;
  const std::string screen = DrawPanel(status, inputs);
  for (const auto* text :
       {"Mission fail    done 15/15  score 100.0  6554 s  hits 255  failure out_of_area\x1b",
        "Bomb disrupted", "Grasp contact_right", "Fire armed_wait", "Circuits ready 1 2 3\x1b",
        "Speed creep 100 %  Joints  30 %\x1b", "Module outdoor", "Exercise 12 ", "Camera gripper",
        "Light gripper", "Preset ground_pick\x1b", "Arm key armed", "Circuit 2",
        "Fire left released", "right pressed"}) {
    EXPECT_NE(screen.find(text), std::string::npos) << text << "\n" << screen;
  }
}

TEST(Screen, LegendNamesEveryKeyThatDoesSomething) {
  const std::string screen = DrawPanel(PanelStatus{}, {});
  const std::string legend = screen.substr(screen.find(" arrows drive"));
  for (char c = '!'; c <= '~'; ++c) {
    OperatorHands hands;
    if (PressKey(Character(c), At(seconds(0)), hands) == KeyOutcome::kUnused) continue;
    // A key stands alone, or in a pair such as "y/h".
    bool is_named = false;
    for (size_t i = legend.find(c); i != std::string::npos; i = legend.find(c, i + 1)) {
      const bool begins = legend[i - 1] == ' ' || legend[i - 1] == '/';
      const bool ends = legend[i + 1] == ' ' || legend[i + 1] == '/';
      is_named = is_named || (begins && ends);
    }
    EXPECT_TRUE(is_named) << c;
  }
}

TEST(Screen, ShowsPayloadAndTiltAsReasons) {
  PanelStatus status;
  status.feedback.inhibit_mask = 1u << 8;
  status.feedback.inhibit_reason = dbc::InhibitReason::kPayload;
  EXPECT_NE(DrawPanel(status, {}).find("Inhibited M09 (payload)"), std::string::npos);
  status.feedback.inhibit_reason = dbc::InhibitReason::kTilt;
  EXPECT_NE(DrawPanel(status, {}).find("Inhibited M09 (tilt)"), std::string::npos);
}

TEST(Screen, ShowsLitLampsInColourAndInhibitedMotions) {
  PanelStatus status;
  status.feedback.inhibit_mask = 1;
  status.feedback.inhibit_reason = dbc::InhibitReason::kCollision;
  const std::string dark = DrawPanel(status, {});
  EXPECT_NE(dark.find("Inhibited M01 (collision)"), std::string::npos);
  EXPECT_EQ(dark.find("\x1b[97;41m"), std::string::npos);
  EXPECT_EQ(DrawPanel(PanelStatus{}, {}).find("Inhibited none ("), std::string::npos);
  status.lit[static_cast<size_t>(dbc::Lamp::kCollision)] = true;
  EXPECT_NE(DrawPanel(status, {}).find("\x1b[97;41mcollision \x1b[0m"), std::string::npos);
}

TEST(Screen, NamesTheAlarmBesideItsCode) {
  PanelStatus status;
  status.feedback.alarm_code = 64;
  EXPECT_NE(DrawPanel(status, {}, "bomb_touched").find("Alarm 64 bomb_touched\x1b"),
            std::string::npos);
  EXPECT_NE(DrawPanel(PanelStatus{}, {}).find("Alarm none\x1b"), std::string::npos);
}

TEST(Screen, KeepsTheReasonInSightHoweverManyMotionsAreInhibited) {
  PanelStatus status;
  status.feedback.inhibit_reason = dbc::InhibitReason::kNeutralNeeded;
  for (uint32_t mask : {0x3FFFFFu, 0x155555u, 0x1B6DB6u, 0x2EEEEEu}) {
    status.feedback.inhibit_mask = mask;
    EXPECT_NE(DrawPanel(status, {}).find("(neutral_needed)\x1b"), std::string::npos)
        << MotionsText(mask);
  }
}

TEST(Journal, JoinsThreeOrMoreMotionsInARow) {
  EXPECT_EQ(MotionsText(0), "none");
  EXPECT_EQ(MotionsText(0b11), "M01 M02");
  EXPECT_EQ(MotionsText(0b1110101), "M01 M03 M05-M07");
  EXPECT_EQ(MotionsText(0x3FFFFF), "M01-M22");
  EXPECT_EQ(MotionsText(1u << 21 | 1u << 20), "M21 M22");
}

TEST(Journal, TellsEachChangeOnce) {
  PanelJournal dut;
  PanelStatus status;
  EXPECT_TRUE(dut.Observe(status).empty());
  status.lamp[static_cast<size_t>(dbc::Lamp::kCollision)] = dbc::LampPattern::kFastBlink;
  status.feedback.inhibit_mask = 1;
  status.feedback.inhibit_reason = dbc::InhibitReason::kCollision;
  status.feedback.hit_parts = 3;
  EXPECT_EQ(dut.Observe(status),
            (std::vector<std::string>{"lamp collision fast", "inhibited M01 (collision)",
                                      "contact front left wheel, front right wheel"}));
  EXPECT_TRUE(dut.Observe(status).empty());
}

TEST(Journal, TellsANewReasonForTheSameMotions) {
  PanelJournal dut;
  PanelStatus status;
  status.feedback.inhibit_mask = 1u << 8;
  status.feedback.inhibit_reason = dbc::InhibitReason::kPayload;
  EXPECT_EQ(dut.Observe(status), std::vector<std::string>{"inhibited M09 (payload)"});
  status.feedback.inhibit_reason = dbc::InhibitReason::kTilt;
  EXPECT_EQ(dut.Observe(status), std::vector<std::string>{"inhibited M09 (tilt)"});
}

TEST(Journal, TellsGraspBombFireAndTheMissionsSteps) {
  PanelJournal dut;
  PanelStatus status;
  status.feedback.grasp_state = 5;
  status.feedback.bomb_state = 4;
  status.feedback.fire_state = 1;
  status.feedback.mission_state = 4;
  status.feedback.fail_reason = 8;
  status.feedback.step = 2;
  status.feedback.steps = 12;
  EXPECT_EQ(dut.Observe(status),
            (std::vector<std::string>{"grasp grasped", "bomb grasped", "fire armed_wait",
                                      "mission fail", "failure bomb_lost", "steps done 2 of 12"}));
  EXPECT_TRUE(dut.Observe(status).empty());
}

}  // namespace
}  // namespace eod::box
