#include "firmware_emu/condition.h"

#include <array>
#include <span>
#include <string_view>

#include <fmt/format.h>

#include "firmware_emu/seen_condition.h"
#include "firmware_emu/vocabulary.h"

namespace eod::box {
namespace {

using Subject = Condition::Subject;
using Comparison = Condition::Comparison;

constexpr std::array<std::string_view, 35> kSubjects{
    "lamp",    "lit",      "buzzer", "alarm",      "inhibit", "state",  "robot",
    "mission", "module",   "link",   "heading",    "pitch",   "roll",   "speed",
    "joint",   "score",    "step",   "collisions", "battery", "travel", "turned",
    "grasp",   "bomb",     "fire",   "reason",     "failure", "x",      "y",
    "z",       "distance", "ahead",  "side",       "height",  "tilt",   "seen"};
constexpr std::array<std::string_view, 4> kComparisons{">=", "<=", ">", "<"};
constexpr std::array<std::string_view, 2> kDownUp{"down", "up"};
constexpr int kAnyPattern = 1;  // "on": lit steadily or blinking

int TakeAlarmCode(WordReader& words) {
  if (words.TakeIf("none")) return 0;
  if (words.TakeIf("any")) return -1;
  return words.TakeInteger(1, 255);
}

void TakeComparison(Condition& condition, WordReader& words) {
  condition.comparison = static_cast<Comparison>(words.TakeChoice(kComparisons));
  condition.number = words.TakeNumber();
}

double Quantity(const Condition& condition, const PanelStatus& status, const Odometer& odometer) {
  const dbc::RobotFeedback& robot = status.feedback;
  switch (condition.subject) {
    case Subject::kHeading:
      return robot.heading_deg;
    case Subject::kPitch:
      return robot.pitch_deg;
    case Subject::kRoll:
      return robot.roll_deg;
    case Subject::kSpeed:
      return robot.speed_mps;
    case Subject::kJoint:
      return robot.joint[condition.index];
    case Subject::kScore:
      return robot.score;
    case Subject::kStep:
      return robot.step;
    case Subject::kCollisions:
      return robot.collisions;
    case Subject::kBattery:
      return robot.battery_soc * 100;
    case Subject::kTravel:
      return odometer.travel_m();
    case Subject::kTurned:
      return odometer.turned_deg();
    default:
      return 0;
  }
}

bool Compare(const Condition& condition, double value) {
  double difference = value - condition.number;
  // 350 degrees lie to the right of 10, not far to the left.
  if (condition.subject == Subject::kHeading) difference = WrapDegrees(difference);
  switch (condition.comparison) {
    case Comparison::kGreaterEqual:
      return difference >= 0;
    case Comparison::kLessEqual:
      return difference <= 0;
    case Comparison::kGreater:
      return difference > 0;
    case Comparison::kLess:
      return difference < 0;
  }
  return false;
}

bool HoldsByEye(const Condition& condition, const Sight* sight) {
  if (sight == nullptr) return false;
  const std::optional<double> seen = SeenQuantity(condition, *sight);
  if (!seen) return false;
  const bool is_true = condition.subject == Subject::kSeen ? *seen != 0 : Compare(condition, *seen);
  return is_true != condition.is_negated;
}

std::string ObservedByEye(const Condition& condition, const Sight* sight) {
  if (sight == nullptr) return std::string(kNothingSeen);
  const std::string_view subject = kSubjects[static_cast<size_t>(condition.subject)];
  const std::optional<double> seen = SeenQuantity(condition, *sight);
  if (!seen || condition.subject == Subject::kSeen) return NotSeen(condition.object, *sight);
  return IsOfObject(condition.subject)
             ? fmt::format("{} {} is {:.3f}", subject, condition.object, *seen)
             : fmt::format("{} is {:.3f}", subject, *seen);
}

bool MatchesPattern(int wanted, dbc::LampPattern shown) {
  if (wanted == kAnyPattern) return shown != dbc::LampPattern::kOff;
  return wanted == static_cast<int>(shown);
}

// What a subject with named values shows now, as an index into its words.
int Shown(const Condition& condition, const PanelStatus& status) {
  switch (condition.subject) {
    case Subject::kLamp:
      return static_cast<int>(status.lamp[condition.index]);
    case Subject::kLit:
      return status.lit[condition.index] ? 1 : 0;
    case Subject::kBuzzer:
      return static_cast<int>(status.buzzer);
    case Subject::kAlarm:
      return status.feedback.alarm_code;
    case Subject::kBoxState:
      return static_cast<int>(status.state);
    case Subject::kRobotState:
      return static_cast<int>(status.feedback.state);
    case Subject::kMission:
      return status.feedback.mission_state;
    case Subject::kModule:
      return static_cast<int>(status.feedback.module);
    case Subject::kLink:
      return status.link_up ? 1 : 0;
    case Subject::kGrasp:
      return status.feedback.grasp_state;
    case Subject::kBomb:
      return status.feedback.bomb_state;
    case Subject::kFire:
      return status.feedback.fire_state;
    case Subject::kReason:
      return static_cast<int>(status.feedback.inhibit_reason);
    case Subject::kFailure:
      return status.feedback.fail_reason;
    default:
      return 0;
  }
}

bool IsTrue(const Condition& condition, const PanelStatus& status, const Odometer& odometer) {
  const uint32_t inhibited = status.feedback.inhibit_mask;
  switch (condition.subject) {
    case Subject::kLamp:
      return MatchesPattern(condition.choice, status.lamp[condition.index]);
    case Subject::kBuzzer:
      return (status.buzzer != dbc::BuzzerPattern::kOff) == (condition.choice == 1);
    case Subject::kAlarm:
      return condition.choice < 0 ? Shown(condition, status) != 0
                                  : Shown(condition, status) == condition.choice;
    case Subject::kInhibit:
      return condition.motions == 0 ? inhibited == 0
                                    : (inhibited & condition.motions) == condition.motions;
    case Subject::kLit:
    case Subject::kBoxState:
    case Subject::kRobotState:
    case Subject::kMission:
    case Subject::kModule:
    case Subject::kLink:
    case Subject::kGrasp:
    case Subject::kBomb:
    case Subject::kFire:
    case Subject::kReason:
    case Subject::kFailure:
      return Shown(condition, status) == condition.choice;
    default:
      return Compare(condition, Quantity(condition, status, odometer));
  }
}

std::span<const std::string_view> ValueWords(Subject subject) {
  switch (subject) {
    case Subject::kLamp:
      return words::kLampPattern;
    case Subject::kLit:
      return words::kOffOn;
    case Subject::kBuzzer:
      return words::kBuzzer;
    case Subject::kBoxState:
      return words::kBoxState;
    case Subject::kRobotState:
      return words::kRobotState;
    case Subject::kMission:
      return words::kMission;
    case Subject::kModule:
      return words::kModule;
    case Subject::kLink:
      return kDownUp;
    case Subject::kGrasp:
      return words::kGrasp;
    case Subject::kBomb:
      return words::kBomb;
    case Subject::kFire:
      return words::kFireState;
    case Subject::kReason:
      return words::kInhibitReason;
    case Subject::kFailure:
      return words::kFailure;
    default:
      return {};
  }
}

std::string SubjectText(const Condition& condition) {
  const std::string_view subject = kSubjects[static_cast<size_t>(condition.subject)];
  if (condition.subject == Subject::kLamp || condition.subject == Subject::kLit) {
    return fmt::format("{} {}", subject, words::kLamp[condition.index]);
  }
  if (condition.subject == Subject::kJoint) return fmt::format("joint {}", condition.index + 1);
  return std::string(subject);
}

}  // namespace

Condition ParseCondition(WordReader& words) {
  Condition condition;
  condition.is_negated = words.TakeIf("not");
  condition.subject = static_cast<Subject>(words.TakeChoice(kSubjects));
  switch (condition.subject) {
    case Subject::kLamp:
    case Subject::kLit:
      condition.index = words.TakeChoice(words::kLamp);
      condition.choice = words.TakeChoice(ValueWords(condition.subject));
      break;
    case Subject::kBuzzer:
      condition.choice = words.TakeChoice(words::kOffOn);
      break;
    case Subject::kAlarm:
      condition.choice = TakeAlarmCode(words);
      break;
    case Subject::kInhibit:
      if (!words.TakeIf("none")) condition.motions = words.TakeMotions();
      break;
    case Subject::kBoxState:
    case Subject::kRobotState:
    case Subject::kMission:
    case Subject::kModule:
    case Subject::kLink:
    case Subject::kGrasp:
    case Subject::kBomb:
    case Subject::kFire:
    case Subject::kReason:
    case Subject::kFailure:
      condition.choice = words.TakeChoice(ValueWords(condition.subject));
      break;
    case Subject::kJoint:
      condition.index = words.TakeInteger(1, dbc::kJointCount) - 1;
      TakeComparison(condition, words);
      break;
    case Subject::kSeen:
      condition.object = words.Take("the name of an object");
      break;
    default:
      if (IsOfObject(condition.subject)) condition.object = words.Take("the name of an object");
      TakeComparison(condition, words);
  }
  return condition;
}

bool Holds(const Condition& condition, const PanelStatus& status, const Odometer& odometer,
           const Sight* sight) {
  if (IsByEye(condition.subject)) return HoldsByEye(condition, sight);
  return IsTrue(condition, status, odometer) != condition.is_negated;
}

std::string Observed(const Condition& condition, const PanelStatus& status,
                     const Odometer& odometer, const Sight* sight) {
  if (IsByEye(condition.subject)) return ObservedByEye(condition, sight);
  const std::string subject = SubjectText(condition);
  if (condition.subject == Subject::kInhibit) {
    return fmt::format("inhibit mask is 0x{:06X}", status.feedback.inhibit_mask);
  }
  if (condition.subject == Subject::kAlarm) {
    return fmt::format("alarm is {}", status.feedback.alarm_code);
  }
  const std::span<const std::string_view> values = ValueWords(condition.subject);
  if (values.empty()) {
    return fmt::format("{} is {:.3f}", subject, Quantity(condition, status, odometer));
  }
  const auto shown = static_cast<size_t>(Shown(condition, status));
  return fmt::format("{} is {}", subject, shown < values.size() ? values[shown] : "unknown");
}

}  // namespace eod::box
