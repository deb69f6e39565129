#include "recorder/status_line.h"

#include <array>
#include <string_view>
#include <vector>

#include <fmt/format.h>

namespace eod::recorder {
namespace {

struct LampText {
  std::string_view tag;
  std::string_view name;
  int colour;  ///< ANSI background
};

constexpr int kGreen = 42;
constexpr int kYellow = 43;
constexpr int kRed = 41;
constexpr int kBlue = 44;

constexpr std::array<LampText, dbc::kLampCount> kLamps{{{"PWR", "power", kGreen},
                                                        {"LNK", "link", kGreen},
                                                        {"EST", "e-stop", kRed},
                                                        {"DMN", "deadman", kGreen},
                                                        {"COL", "collision", kRed},
                                                        {"LIM", "limit", kYellow},
                                                        {"TLT", "tilt", kYellow},
                                                        {"BAT", "battery", kYellow},
                                                        {"ARM", "armed", kRed},
                                                        {"FIR", "fired", kRed},
                                                        {"GRP", "grasp", kGreen},
                                                        {"MIS", "mission", kBlue},
                                                        {"FLT", "fault", kRed},
                                                        {"CAM", "camera", kBlue}}};

// A piece of the line: its text with escapes, and the width that is seen.
struct Piece {
  std::string text;
  size_t width = 0;
  bool escaped = false;  ///< must not be cut
};

Piece Plain(std::string text) {
  // Continuation bytes of UTF-8 take no column.
  size_t width = 0;
  for (const char c : text) width += (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
  return {std::move(text), width, false};
}

Piece Lamps(const LampPatterns& lamps, bool colour) {
  Piece piece;
  piece.escaped = colour;
  for (size_t i = 0; i < lamps.size(); ++i) {
    if (lamps[i] == dbc::LampPattern::kOff) continue;
    const bool blinks = lamps[i] != dbc::LampPattern::kOn;
    const std::string tag = fmt::format("{}{}", kLamps[i].tag, blinks ? "*" : "");
    if (piece.width > 0) {
      piece.text += ' ';
      ++piece.width;
    }
    piece.text += colour ? fmt::format("\033[30;{}m{}\033[0m", kLamps[i].colour, tag) : tag;
    piece.width += tag.size();
  }
  return piece.width > 0 ? piece : Plain("no lamp");
}

std::string LinkText(const std::optional<LinkSeen>& link) {
  if (!link) return "link -";
  constexpr std::array<std::string_view, 3> kBusStates{"up", "bus down", "bus off"};
  if (link->bus_state == 1 || link->bus_state == 2) {
    return fmt::format("link {}", kBusStates[static_cast<size_t>(link->bus_state)]);
  }
  return fmt::format("link {:.0f}%", link->quality * 100);
}

// What happens: the step of the exercise, or else what the scripted operator does.
std::string ActionText(const MissionSeen& mission, const std::string& script_line) {
  switch (mission.state) {
    case MissionState::kRun:
      return fmt::format("{}/{} {}", mission.step + 1, mission.steps, mission.step_text);
    case MissionState::kSuccess:
      return "mission accomplished";
    case MissionState::kFail:
      return "mission failed";
    case MissionState::kAbort:
      return "mission aborted";
    case MissionState::kIdle:
    case MissionState::kBrief:
      break;
  }
  return script_line;
}

// Cuts at a character's border, never inside one.
std::string Shortened(const std::string& text, size_t width) {
  size_t seen = 0;
  for (size_t i = 0; i < text.size(); ++i) {
    const bool begins = (static_cast<unsigned char>(text[i]) & 0xC0U) != 0x80U;
    if (begins && seen++ == width) return text.substr(0, i);
  }
  return text;
}

}  // namespace

std::string FormatStatusLine(const LiveStatus& status, const LineStyle& style) {
  std::vector<Piece> pieces{Plain(fmt::format("{:6.1f} s", status.t)),
                            Lamps(status.lamps, style.colour),
                            Plain(fmt::format("{:+.2f} m/s", status.speed_mps)),
                            Plain("inhibited " + MotionNames(status.inhibit_mask)),
                            Plain(fmt::format("{:.0f} fps", status.camera_fps)),
                            Plain(LinkText(status.link)),
                            Plain(ActionText(status.mission, status.script_line))};
  const auto columns = static_cast<size_t>(style.columns);
  std::string line;
  size_t width = 0;
  for (const Piece& piece : pieces) {
    if (piece.width == 0) continue;
    const size_t gap = width > 0 ? 2 : 0;
    const bool fits = width + gap + piece.width <= columns;
    // Of plain text that does not fit, as much stands as still says something.
    if (!fits && (piece.escaped || width + gap + 8 > columns)) break;
    line += std::string(gap, ' ');
    line += fits ? piece.text : Shortened(piece.text, columns - width - gap);
    width += gap + piece.width;
    if (!fits) break;
  }
  return line;
}

std::string_view LampTag(dbc::Lamp lamp) { return kLamps[static_cast<size_t>(lamp)].tag; }
std::string_view LampName(dbc::Lamp lamp) { return kLamps[static_cast<size_t>(lamp)].name; }

std::string MotionNames(uint32_t inhibit_mask) {
  constexpr uint32_t kAll = (1U << dbc::kMotionCount) - 1;
  if ((inhibit_mask & kAll) == 0) return "none";
  if ((inhibit_mask & kAll) == kAll) return "all";
  std::string text;
  for (int motion = 1; motion <= dbc::kMotionCount; ++motion) {
    if ((inhibit_mask >> (motion - 1) & 1U) == 0) continue;
    text += fmt::format("{}M{:02d}", text.empty() ? "" : " ", motion);
  }
  return text;
}

}  // namespace eod::recorder
