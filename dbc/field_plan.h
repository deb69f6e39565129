#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "dbc/control_map.h"
#include "dbc/database.h"
#include "dbc/roles.h"
#include "dbc/signal_plan.h"

namespace eod::dbc {

/// How one role stands in one signal, compiled at load from role, map and DBC: bits, labels, unit.
/// Decode and encode neither allocate nor throw, and no bits decode to an infinity or, but for an
/// invalid axis, to NaN.
class FieldPlan {
 public:
  /// Throws std::runtime_error that says what does not fit (without the file's name and line).
  FieldPlan(const RoleSpec& role, const MappedSignal& mapped, const Signal& signal,
            int message_length);

  /// The role's value in `payload`; its safe value if the bits hold no valid one: an unknown raw
  /// value of a choice, a value outside the range that the DBC declares.
  double Decode(std::span<const uint8_t> payload) const;
  /// Writes `value`, limited to the range that the DBC declares.
  void Encode(double value, std::span<uint8_t> payload) const;

 private:
  struct Label {
    int value;
    int64_t raw;
  };

  void CompileFallback();
  double DecodeChoice(int64_t raw) const;
  double DecodeFlag(int64_t raw) const;
  double DecodeNumber(int64_t raw) const;
  int64_t EncodeChoice(double value) const;
  int64_t EncodeNumber(double value) const;
  bool IsInRange(double physical) const;

  SignalPlan plan_;
  RoleKind kind_;
  bool inverted_;
  double safe_;
  double scale_ = 1;  ///< SI per unit of the DBC
  bool has_range_;
  double minimum_;  ///< in the unit of the DBC, as the next two
  double maximum_;
  double tolerance_;
  std::vector<Label> labels_;
  int fallback_;
  int64_t raw_fallback_ = 0;  ///< sent for a value without a label, and for an invalid axis
};

}  // namespace eod::dbc
