// What happened, in words.
#include <array>

#include <fmt/format.h>

#include "sim/score/scorer.h"
#include "sim/score/sheet_words.h"

namespace eod::sim {
namespace {

constexpr std::array<std::string_view, 9> kJoints = {
    "Front flippers", "Rear flippers", "Big arm",    "Small arm",  "Wrist",
    "Gripper",        "Hands",         "Mast (pan)", "Mast (tilt)"};

/// Name of the item that an event belongs to, and of its part.
struct MarkName {
  std::string_view part;
  std::string_view name;
};
constexpr std::array kMarks = {  // as ScoreMark
    MarkName{"steps", "step"},         MarkName{"safety", "collision"},
    MarkName{"safety", "pushing"},     MarkName{"safety", "tilt"},
    MarkName{"safety", "bomb_touch"},  MarkName{"safety", "fire_rule"},
    MarkName{"safety", "fire_rule"},   MarkName{"safety", "fire_rule"},
    MarkName{"safety", "fire_rule"},   MarkName{"safety", "unseen_driving"},
    MarkName{"safety", "procedure"},   MarkName{"economy", "reversal"},
    MarkName{"economy", "undone"},     MarkName{"economy", "joint_limit"},
    MarkName{"precision", "measured"}, MarkName{"failure", "critical_failure"}};

/// Of what needs no more than the event itself, and the name of the thing concerned.
std::string PlainText(const ScoreEvent& event, const std::string& object) {
  switch (event.mark) {
    case ScoreMark::kCollision:
      return fmt::format("Collision with {}", object);
    case ScoreMark::kPushing:
      return fmt::format("Pushed on against {} for {:.1f} s more", object, event.amount);
    case ScoreMark::kTilt:
      return fmt::format("Tilted to {:.1f} degrees", event.amount);
    case ScoreMark::kTouch:
      return "Charge touched, not grasped";
    case ScoreMark::kFireButton:
      return "Fire button pressed without a ready circuit";
    case ScoreMark::kOneHand:
      return fmt::format("{} fire button held alone", event.index == 0 ? "Left" : "Right");
    case ScoreMark::kArmedDriving:
      return "Arm key armed on the move";
    case ScoreMark::kFireTimeOut:
      return "Armed until the circuit timed out";
    case ScoreMark::kUnseen:
      return fmt::format("Drove {} without a camera on the way",
                         event.index > 0 ? "forward" : "backward");
    case ScoreMark::kReversal:
      return event.index == 0 ? "Drove back at once" : "Turned back at once";
    case ScoreMark::kUndone:
      return fmt::format("{}: {:.0f} degrees, taken back at once", Named(kJoints, event.index, ""),
                         event.amount);
    case ScoreMark::kLimit:
      return fmt::format("{}: driven against the limit", Named(kJoints, event.index, ""));
    case ScoreMark::kFailed:
      return fmt::format("Mission failed: {}", Named(kFailures, event.index, "unknown"));
    default:
      return "";
  }
}

}  // namespace

std::string Scorer::TextOfEvent(const ScoreEvent& event) const {
  const auto index = static_cast<size_t>(event.index);
  switch (event.mark) {
    case ScoreMark::kStep:
      return fmt::format("Step {} complete: {}", index + 1, scenario_.steps[index].text);
    case ScoreMark::kProcedure:
      return fmt::format("{}: {}", TextOf(procedure_.spec(index)),
                         NameOf(static_cast<ProcedureResult>(event.amount)));
    case ScoreMark::kMeasured: {
      const PrecisionSpec& spec = precision_.spec(index);
      const std::string_view unit = UnitOf(spec.kind);
      return fmt::format("{}: {:.3g}{}{}", TextOf(spec), InUnit(spec, event.amount),
                         unit.empty() ? "" : " ", unit);
    }
    default:
      return PlainText(event, Named(names_, event.object, "something"));
  }
}

SheetEvent Scorer::Describe(const ScoreEvent& event) const {
  const MarkName& mark = kMarks[static_cast<size_t>(event.mark)];
  return {.time_s = event.time_s,
          .part = std::string(mark.part),
          .name = std::string(mark.name),
          .text = TextOfEvent(event),
          .points = event.points,
          .position = event.position};
}

}  // namespace eod::sim
