#include "firmware_emu/panel_screen.h"

#include <algorithm>
#include <array>
#include <span>
#include <string_view>

#include <fmt/format.h>

#include "firmware_emu/panel_journal.h"
#include "firmware_emu/vocabulary.h"

namespace eod::box {
namespace {

constexpr std::string_view kPlain = "\x1b[0m";
constexpr std::string_view kDim = "\x1b[2m";
constexpr std::string_view kGreen = "\x1b[30;42m";
constexpr std::string_view kYellow = "\x1b[30;43m";
constexpr std::string_view kRed = "\x1b[97;41m";
constexpr std::string_view kHome = "\x1b[H";
constexpr std::string_view kEndOfLine = "\x1b[K\r\n";

using dbc::Lamp;

// Lens colours as IEC 60204-1 has them: red emergency, yellow abnormal, green normal.
std::string_view LensColour(int lamp) {
  switch (static_cast<Lamp>(lamp)) {
    case Lamp::kEstop:
    case Lamp::kCollision:
    case Lamp::kFired:
    case Lamp::kFault:
      return kRed;
    case Lamp::kLimit:
    case Lamp::kTilt:
    case Lamp::kBattery:
    case Lamp::kArmed:
      return kYellow;
    default:
      return kGreen;
  }
}

template <typename Enum>
std::string_view WordOf(std::span<const std::string_view> words, Enum value) {
  const auto index = static_cast<size_t>(value);
  return index < words.size() ? words[index] : "?";
}

std::string Line(std::string_view text) {
  return fmt::format("{}{}", text.substr(0, kScreenWidth), kEndOfLine);
}

// The code as conditions of scripts have it, and its name.
std::string AlarmText(int code, std::string_view name) {
  return code == 0 ? "none" : fmt::format("{} {}", code, name);
}

std::string LampRow(const PanelStatus& status, int first, int last) {
  std::string row = " ";
  for (int i = first; i < last; ++i) {
    row +=
        fmt::format("{}{:^10}{} ", status.lit[i] ? LensColour(i) : kDim, words::kLamp[i], kPlain);
  }
  return row + std::string(kEndOfLine);
}

std::string JointRows(const dbc::RobotFeedback& robot) {
  const auto& j = robot.joint;
  return Line(fmt::format(
             " Flippers front {:7.2f}  rear {:7.2f}   Gripper roll {:7.2f}  opening {:6.1f} mm",
             j[0], j[1], j[5], j[6] * 1000)) +
         Line(fmt::format(
             " Arm big {:7.2f}  small {:7.2f}  wrist {:7.2f}  Camera pan {:7.2f} tilt {:7.2f}",
             j[2], j[3], j[4], j[7], j[8]));
}

std::string CircuitsText(uint32_t continuity) {
  std::string text;
  for (int circuit = 1; circuit <= 3; ++circuit) {
    if ((continuity >> (circuit - 1) & 1u) != 0) text += fmt::format(" {}", circuit);
  }
  return text.empty() ? " none" : text;
}

std::string MissionRows(const dbc::RobotFeedback& robot) {
  return Line(fmt::format(" Mission {:<7} done {}/{}  score {:.1f}  {:.0f} s  hits {}  failure {}",
                          WordOf(words::kMission, robot.mission_state), robot.step, robot.steps,
                          robot.score, robot.elapsed_s, robot.collisions,
                          WordOf(words::kFailure, robot.fail_reason))) +
         Line(fmt::format(
             " Bomb {:<9}  Grasp {:<13}  Fire {:<10}  Circuits ready{}",
             WordOf(words::kBomb, robot.bomb_state), WordOf(words::kGrasp, robot.grasp_state),
             WordOf(words::kFireState, robot.fire_state), CircuitsText(robot.circuit_continuity)));
}

std::string ControlRows(const PanelInputs& inputs) {
  const dbc::PanelState& controls = inputs.controls;
  return Line(fmt::format(
             " Key {:<11} E-stop {:<7} Deadman {:<8} Speed {:<5} {:3.0f} %  Joints {:3.0f} %",
             WordOf(words::kKey, controls.key), inputs.estop_pressed ? "PRESSED" : "out",
             WordOf(words::kDeadman, controls.deadman), WordOf(words::kSpeed, controls.speed_range),
             controls.speed_limit * 100, controls.joint_rate * 100)) +
         Line(fmt::format(" Module {:<7} Exercise {:<3} Camera {:<8} Light {:<8} Preset {}",
                          WordOf(words::kModule, controls.menu_module), controls.menu_exercise,
                          WordOf(words::kCamera, controls.camera),
                          WordOf(words::kLight, controls.light),
                          WordOf(words::kPreset, controls.preset))) +
         Line(fmt::format(" Arm key {:<7} Circuit {}        Fire left {:<9} right {}",
                          WordOf(words::kArmKey, controls.arm_key), controls.circuit,
                          WordOf(words::kFireButton, controls.fire_left),
                          WordOf(words::kFireButton, controls.fire_right)));
}

uint32_t PressedMotions(const PanelStatus& status) {
  uint32_t pressed = 0;
  for (int m = 0; m < dbc::kMotionCount; ++m) pressed |= (status.reported.motion[m] ? 1u : 0u) << m;
  return pressed;
}

constexpr std::array<std::string_view, 9> kLegend{
    " arrows drive, turn  SPACE e-stop  z release it  x deadman  n reset  ENTER start",
    " m key switch   1 2 3 creep low high   , . speed limit   4 5 rate of the joints",
    " c camera  l light  v lamp test  b buzzer off  B alarm reset  Q or Ctrl-C quit",
    " 8 module M exercise 9 start 0 reset 6 pause 7 resume E end Drive: m m x n ENTER",
    " y/h front flipper   u/j rear flipper   q/a big arm   w/s small arm   e/d wrist",
    " r/f gripper roll    t/g gripper open/close   o/p pan left/right   i/k tilt",
    " Presets: S stow T travel G ground pick C carry D can drop  U/J stair up, down",
    " Fire: A arm key   N next circuit   L left, R right: each stays down for 1 s",
    " Tap a key for 0.3 s of its motion or preset; to go on, keep it down.",
};
static_assert(std::ranges::all_of(kLegend, [](std::string_view text) {
  return text.size() <= kScreenWidth;
}));

}  // namespace

std::string DrawPanel(const PanelStatus& status, const PanelInputs& inputs,
                      std::string_view alarm) {
  const dbc::RobotFeedback& robot = status.feedback;
  const std::string_view buzzer = WordOf(words::kBuzzer, status.buzzer);
  std::string screen(kHome);
  screen += Line(fmt::format(" EOD CONTROL BOX   box {:<10} robot {:<10} link {:<5} rx {}",
                             WordOf(words::kBoxState, status.state),
                             WordOf(words::kRobotState, robot.state),
                             status.link_up ? "up" : "DOWN", status.rx));
  screen += LampRow(status, 0, 7) + LampRow(status, 7, dbc::kLampCount);
  screen += Line(fmt::format(" Buzzer {:<11} {:<11} Battery {:3.0f} %  Alarm {}", buzzer,
                             status.is_sounding ? "((( o )))" : "    o", robot.battery_soc * 100,
                             AlarmText(robot.alarm_code, alarm)));
  screen +=
      Line(fmt::format(" Speed {:6.2f} m/s   heading {:6.1f}   pitch {:5.1f}   roll {:5.1f} deg",
                       robot.speed_mps, robot.heading_deg, robot.pitch_deg, robot.roll_deg));
  screen += JointRows(robot) + MissionRows(robot);
  screen += Line(fmt::format(" Pressed   {}", MotionsText(PressedMotions(status))));
  const std::string reason =
      robot.inhibit_reason == dbc::InhibitReason::kNone
          ? ""
          : fmt::format(" ({})", WordOf(words::kInhibitReason, robot.inhibit_reason));
  constexpr std::string_view kInhibited = " Inhibited ";
  const size_t room = kScreenWidth - kInhibited.size() - reason.size();
  screen +=
      Line(fmt::format("{}{:.{}}{}", kInhibited, MotionsText(robot.inhibit_mask), room, reason));
  screen += Line(fmt::format(" Contact   {}", PartsText(robot.hit_parts)));
  screen += ControlRows(inputs);
  for (const std::string_view text : kLegend) screen += Line(text);
  screen.erase(screen.size() - 2);  // no line feed after the last line: the screen would scroll
  return screen;
}

}  // namespace eod::box
