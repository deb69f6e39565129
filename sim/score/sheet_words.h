#pragma once

#include <array>
#include <numbers>
#include <string>
#include <string_view>

#include "sim/scenario/precision_spec.h"
#include "sim/scenario/procedure_spec.h"

namespace eod::sim {

/// Why missions fail, by ROB_MISSION.FailReason, as the box names it.
inline constexpr std::array<std::string_view, 10> kFailures = {
    "none",      "exploded", "time_out",   "rollover",  "out_of_area",
    "link_lost", "estop",    "instructor", "bomb_lost", "wrong_order"};
/// The name of that number; `otherwise` if there is none.
template <typename Names>
std::string Named(const Names& names, int index, std::string_view otherwise) {
  const auto i = static_cast<size_t>(index);
  return std::string(index >= 0 && i < names.size() ? std::string_view(names[i]) : otherwise);
}

/// A measure in the unit of its kind.
inline double InUnit(const PrecisionSpec& spec, double value) {
  return UnitOf(spec.kind) == "deg" ? value * (180 / std::numbers::pi) : value;
}

/// What a report calls a measure or an item of the check list.
inline std::string TextOf(const PrecisionSpec& spec) {
  if (!spec.text.empty()) return spec.text;
  std::string text(NameOf(spec.kind));
  for (char& c : text) c = c == '_' ? ' ' : c;
  return text;
}

inline std::string TextOf(const ProcedureSpec& spec) {
  return spec.text.empty() ? std::string(TextOf(spec.kind)) : spec.text;
}

}  // namespace eod::sim
