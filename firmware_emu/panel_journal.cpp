#include "firmware_emu/panel_journal.h"

#include <span>
#include <string_view>

#include <fmt/format.h>

#include "firmware_emu/vocabulary.h"

namespace eod::box {
namespace {

template <typename Enum>
std::string_view WordOf(std::span<const std::string_view> words, Enum value) {
  const auto index = static_cast<size_t>(value);
  return index < words.size() ? words[index] : "unknown";
}

// Names of the set bits, with `separator` between them.
template <typename NameOfBit>
std::string BitsText(uint32_t mask, int bits, std::string_view separator, NameOfBit name_of_bit) {
  std::string text;
  for (int bit = 0; bit < bits; ++bit) {
    if ((mask >> bit & 1u) == 0) continue;
    if (!text.empty()) text += separator;
    text += name_of_bit(bit);
  }
  return text.empty() ? "none" : text;
}

}  // namespace

std::string MotionsText(uint32_t mask) {
  std::string text;
  for (int first = 0; first < dbc::kMotionCount; ++first) {
    int last = first;
    while ((mask >> last & 1u) != 0) ++last;
    if (last == first) continue;
    const std::string_view separator = last - first > 2 ? "-" : " ";
    if (!text.empty()) text += ' ';
    text += fmt::format("M{:02}", first + 1);
    if (last - first > 1) text += fmt::format("{}M{:02}", separator, last);
    first = last;
  }
  return text.empty() ? "none" : text;
}

std::string PartsText(uint32_t mask) {
  return BitsText(mask, static_cast<int>(words::kPart.size()), ", ",
                  [](int bit) { return std::string(words::kPart[bit]); });
}

std::string LampsText(const PanelStatus& status) {
  std::string text;
  for (int i = 0; i < dbc::kLampCount; ++i) {
    if (status.lamp[i] == dbc::LampPattern::kOff) continue;
    if (!text.empty()) text += ", ";
    text += fmt::format("{} {}", words::kLamp[i], WordOf(words::kLampPattern, status.lamp[i]));
  }
  return text.empty() ? "none" : text;
}

std::vector<std::string> PanelJournal::Observe(const PanelStatus& status) {
  std::vector<std::string> lines;
  if (status.state != last_.state) {
    lines.push_back(fmt::format("box {}", WordOf(words::kBoxState, status.state)));
  }
  if (status.feedback.state != last_.feedback.state) {
    lines.push_back(fmt::format("robot {}", WordOf(words::kRobotState, status.feedback.state)));
  }
  for (int i = 0; i < dbc::kLampCount; ++i) {
    if (status.lamp[i] == last_.lamp[i]) continue;
    lines.push_back(
        fmt::format("lamp {} {}", words::kLamp[i], WordOf(words::kLampPattern, status.lamp[i])));
  }
  if (status.buzzer != last_.buzzer) {
    lines.push_back(fmt::format("buzzer {}", WordOf(words::kBuzzer, status.buzzer)));
  }
  if (status.feedback.inhibit_mask != last_.feedback.inhibit_mask ||
      status.feedback.inhibit_reason != last_.feedback.inhibit_reason) {
    lines.push_back(fmt::format("inhibited {} ({})", MotionsText(status.feedback.inhibit_mask),
                                WordOf(words::kInhibitReason, status.feedback.inhibit_reason)));
  }
  if (status.feedback.hit_parts != last_.feedback.hit_parts) {
    lines.push_back(fmt::format("contact {}", PartsText(status.feedback.hit_parts)));
  }
  ObserveMission(status.feedback, lines);
  last_ = status;
  return lines;
}

void PanelJournal::ObserveMission(const dbc::RobotFeedback& robot,
                                  std::vector<std::string>& lines) const {
  const dbc::RobotFeedback& last = last_.feedback;
  const auto tell = [&lines](std::string_view what, std::span<const std::string_view> words,
                             int before, int now) {
    if (now != before) lines.push_back(fmt::format("{} {}", what, WordOf(words, now)));
  };
  tell("grasp", words::kGrasp, last.grasp_state, robot.grasp_state);
  tell("bomb", words::kBomb, last.bomb_state, robot.bomb_state);
  tell("fire", words::kFireState, last.fire_state, robot.fire_state);
  tell("mission", words::kMission, last.mission_state, robot.mission_state);
  tell("failure", words::kFailure, last.fail_reason, robot.fail_reason);
  if (robot.step != last.step) {
    lines.push_back(fmt::format("steps done {} of {}", robot.step, robot.steps));
  }
}

}  // namespace eod::box
