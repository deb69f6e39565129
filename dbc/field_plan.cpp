#include "dbc/field_plan.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "dbc/nearest_name.h"

namespace eod::dbc {
namespace {

/// The sign means nothing to bits that are a flag or a named value.
Signal ForPlan(const Signal& signal, RoleKind kind) {
  Signal plain = signal;
  if (kind == RoleKind::kFlag) plain.is_signed = false;
  return plain;
}

int64_t RawOfLabel(const Signal& signal, const std::string& label) {
  std::vector<std::string> known;
  for (const auto& [raw, text] : signal.labels) {
    if (text == label) return raw;
    known.push_back(text);
  }
  const std::string remedy = known.empty()
                                 ? "the DBC gives it none (VAL_)"
                                 : fmt::format("did you mean \"{}\"?", NearestName(label, known));
  throw std::runtime_error(
      fmt::format("signal {} has no label \"{}\"; {}", signal.name, label, remedy));
}

}  // namespace

FieldPlan::FieldPlan(const RoleSpec& role, const MappedSignal& mapped, const Signal& signal,
                     int message_length)
    : plan_(ForPlan(signal, role.kind), message_length),
      kind_(role.kind),
      inverted_(mapped.inverted),
      safe_(role.safe),
      has_range_(signal.has_range()),
      minimum_(signal.minimum),
      maximum_(signal.maximum),
      tolerance_(plan_.is_float() ? 0 : std::abs(signal.factor) / 2),
      fallback_(role.choice == nullptr ? 0 : role.choice->fallback) {
  if (signal.is_multiplexed()) {
    throw std::runtime_error(
        fmt::format("signal {} is multiplexed, which is not supported here", signal.name));
  }
  if (plan_.is_float() && (kind_ == RoleKind::kFlag || kind_ == RoleKind::kChoice)) {
    throw std::runtime_error(fmt::format("signal {} is a floating-point number", signal.name));
  }
  if (minimum_ > maximum_) {
    throw std::runtime_error(fmt::format("signal {} has the range [{}|{}], minimum above maximum",
                                         signal.name, minimum_, maximum_));
  }
  if (role.dimension != Dimension::kNone) {
    scale_ = UnitScale(role.dimension, signal.unit);
    if (scale_ == 0) {
      throw std::runtime_error(fmt::format("signal {} has the unit \"{}\", allowed: {}",
                                           signal.name, signal.unit, AllowedUnits(role.dimension)));
    }
  }
  if (!mapped.labels.empty()) {
    for (size_t value = 0; value < role.choice->values.size(); ++value) {
      const auto label = mapped.labels.find(std::string(role.choice->values[value]));
      if (label == mapped.labels.end() || label->second.empty()) continue;
      labels_.push_back({static_cast<int>(value), RawOfLabel(signal, label->second)});
    }
  }
  CompileFallback();
}

void FieldPlan::CompileFallback() {
  const auto is_labelled = [this](int64_t raw) {
    return std::any_of(labels_.begin(), labels_.end(),
                       [raw](const Label& label) { return label.raw == raw; });
  };
  for (const Label& label : labels_) {
    // Any code says that an axis is invalid, the first one best.
    if (label.value != fallback_ && kind_ != RoleKind::kAxis) continue;
    raw_fallback_ = label.raw;
    return;
  }
  if (kind_ == RoleKind::kAxis) {
    const int64_t raw = plan_.raw_min();
    raw_fallback_ = IsInRange(plan_.ToPhysical(raw)) ? plan_.ToRaw(0) : raw;
  } else if (!labels_.empty()) {
    // The highest value without a meaning, which by custom is "not available".
    const int64_t lowest = std::max(plan_.raw_min(), plan_.raw_max() - 255);
    int64_t raw = plan_.raw_max();
    while (raw > lowest && is_labelled(raw)) --raw;
    raw_fallback_ = is_labelled(raw) ? labels_.front().raw : raw;
  }
}

bool FieldPlan::IsInRange(double physical) const {
  return !has_range_ || (physical >= minimum_ - tolerance_ && physical <= maximum_ + tolerance_);
}

double FieldPlan::Decode(std::span<const uint8_t> payload) const {
  const int64_t raw = plan_.DecodeRaw(payload);
  switch (kind_) {
    case RoleKind::kFlag:
      return DecodeFlag(raw);
    case RoleKind::kChoice:
      return DecodeChoice(raw);
    default:
      return DecodeNumber(raw);
  }
}

double FieldPlan::DecodeChoice(int64_t raw) const {
  for (const Label& label : labels_) {
    if (label.raw == raw) return label.value;
  }
  return safe_;
}

double FieldPlan::DecodeFlag(int64_t raw) const {
  const bool has_labels = !labels_.empty();
  const double on = has_labels ? DecodeChoice(raw) : static_cast<double>(raw);
  const bool is_known = has_labels
                            ? std::any_of(labels_.begin(), labels_.end(),
                                          [raw](const Label& label) { return label.raw == raw; })
                            : raw == 0 || raw == 1;
  if (!is_known) return safe_;
  return inverted_ ? 1 - on : on;
}

double FieldPlan::DecodeNumber(int64_t raw) const {
  const double physical = plan_.ToPhysical(raw);
  if (!IsInRange(physical)) return safe_;
  if (kind_ == RoleKind::kCount) return std::round(physical);
  const double value = physical * scale_;
  if (kind_ != RoleKind::kAxis) return std::isfinite(value) ? value : safe_;
  for (const Label& label : labels_) {
    if (label.raw == raw) return safe_;
  }
  const double deflection = std::clamp(value, -1.0, 1.0);
  return inverted_ ? -deflection : deflection;
}

void FieldPlan::Encode(double value, std::span<uint8_t> payload) const {
  const bool is_number = kind_ != RoleKind::kFlag && kind_ != RoleKind::kChoice;
  plan_.EncodeRaw(is_number ? EncodeNumber(value) : EncodeChoice(value), payload);
}

int64_t FieldPlan::EncodeChoice(double value) const {
  if (inverted_) value = 1 - value;
  if (kind_ == RoleKind::kFlag && labels_.empty()) return value != 0 ? 1 : 0;
  for (const Label& label : labels_) {
    if (label.value == value) return label.raw;
  }
  return raw_fallback_;
}

int64_t FieldPlan::EncodeNumber(double value) const {
  if (kind_ == RoleKind::kAxis) {
    if (std::isnan(value)) return raw_fallback_;
    value = std::clamp(inverted_ ? -value : value, -1.0, 1.0);
  }
  double physical = std::isnan(value) ? 0 : value / scale_;
  if (has_range_) physical = std::clamp(physical, minimum_, maximum_);
  return plan_.ToRaw(physical);
}

}  // namespace eod::dbc
