#pragma once

#include <cstdint>
#include <optional>

#include <Eigen/Core>

namespace eod::sim {

class TomlTable;

/// What the way between operator and robot does to one kind of traffic, beside what distance does.
struct TrafficSpec {
  double delay = 0;   ///< [s] 0..0.5
  double jitter = 0;  ///< [s] added at random, evenly from 0 to this
  double loss = 0;    ///< 0..1 share of messages that never arrive
  bool operator==(const TrafficSpec&) const = default;
};

/// The link between box and robot, as an exercise wants it.
struct ControlLinkSpec {
  enum class Kind : uint8_t { kIdeal, kRadio, kCable };
  Kind kind = Kind::kIdeal;
  TrafficSpec commands = {};
  TrafficSpec telemetry = {};
  TrafficSpec pictures = {};
  /// Local x, y [m] of the operator's antenna or cable reel; none: the start.
  std::optional<Eigen::Vector2d> base = {};
  double range = 500;         ///< [m] radio: where quality has fallen to 0 in the line of sight
  double wall_loss = 0.15;    ///< radio: share of quality that a wall in the way takes
  double cable_length = 100;  ///< [m]
  bool operator==(const ControlLinkSpec&) const = default;
};

/// Whether nothing gets late or lost: as if box and robot were one.
inline bool IsPlain(const ControlLinkSpec& spec) {
  const TrafficSpec none;
  return spec.kind == ControlLinkSpec::Kind::kIdeal && spec.commands == none &&
         spec.telemetry == none && spec.pictures == none;
}

/// Reads [link]. Throws "FILE:LINE: …".
ControlLinkSpec ReadControlLinkSpec(const TomlTable& table);

}  // namespace eod::sim
