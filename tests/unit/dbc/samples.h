#pragma once

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "dbc/box_codec.h"
#include "dbc/control_map.h"
#include "dbc/database.h"
#include "dbc/roles.h"

namespace eod::dbc {

/// Map, DBC and codec of one box.
struct Box {
  explicit Box(const std::filesystem::path& map_file)
      : map(LoadControlMap(map_file)), database(LoadDatabase(map.dbc)), codec(database, map) {}

  ControlMap map;
  Database database;
  BoxCodec codec;
};

inline std::filesystem::path ShippedMapFile() {
  return std::filesystem::path(EOD_DATA_DIR) / "dbc/control_box.map.toml";
}
inline std::filesystem::path ShuffledMapFile() {
  return std::filesystem::path(EOD_DATA_DIR) / "tests/unit/dbc/data/shuffled_box.map.toml";
}

/// Reproducible numbers (Knuth's MMIX generator), the same on every machine.
class Dice {
 public:
  explicit Dice(uint64_t seed) : state_(seed) {}
  uint64_t Bits() {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return state_ >> 32 | state_ << 32;
  }
  /// Whole number low..high.
  int Roll(int low, int high) {
    return low + static_cast<int>((Bits() & 0xFFFFFFFF) % static_cast<uint64_t>(high - low + 1));
  }

 private:
  uint64_t state_;
};

/// A value of the role that the shipped and the shuffled box both hold exactly.
inline double SampleValue(const RoleSpec& role, Dice& dice) {
  switch (role.kind) {
    case RoleKind::kFlag:
      return dice.Roll(0, 1);
    case RoleKind::kChoice:
      return dice.Roll(0, static_cast<int>(role.choice->values.size()) - 1);
    case RoleKind::kCount:
      return dice.Roll(0, role.key == "circuit_continuity" ? 7 : 15);
    case RoleKind::kAxis:
      return dice.Roll(0, 9) == 0 ? std::nan("") : dice.Roll(-1000, 1000) / 1000.0;
    case RoleKind::kQuantity:
      break;
  }
  switch (role.dimension) {
    case Dimension::kShare:
    case Dimension::kTime:
      return dice.Roll(0, 10) / 10.0;
    case Dimension::kLength:
      return dice.Roll(0, 1200) / 1e4;  // 0.1 mm
    case Dimension::kSpeed:
      return dice.Roll(-670, 670) / 1e3;
    case Dimension::kAngle:
      return dice.Roll(role.key == "heading" ? 0 : -60, 60);
    case Dimension::kCurrent:
      return dice.Roll(-100, 100);
    default:
      return dice.Roll(0, 50);
  }
}

/// A state with every field at random, equal for equal seeds.
template <typename State>
State SampleState(const std::vector<Role<State>>& roles, uint64_t seed) {
  Dice dice(seed);
  State state;
  for (const auto& role : roles) role.set(state, role.index, SampleValue(role, dice));
  return state;
}

/// Compares every field; quantities to a billionth, as different scales round differently.
template <typename State>
void ExpectSameFields(const std::vector<Role<State>>& roles, const State& a, const State& b) {
  for (const auto& role : roles) {
    const double value_a = role.get(a, role.index);
    const double value_b = role.get(b, role.index);
    if (std::isnan(value_a) || std::isnan(value_b)) {
      EXPECT_EQ(std::isnan(value_a), std::isnan(value_b)) << role.name;
    } else if (role.kind == RoleKind::kQuantity || role.kind == RoleKind::kAxis) {
      EXPECT_NEAR(value_a, value_b, 1e-9) << role.name;
    } else {
      EXPECT_EQ(value_a, value_b) << role.name;
    }
  }
}

/// Message of the first error; fails the test if `action` throws nothing.
template <typename Action>
std::string ErrorOf(Action action) {
  try {
    action();
  } catch (const std::exception& error) {
    return error.what();
  }
  ADD_FAILURE() << "nothing was thrown";
  return {};
}

}  // namespace eod::dbc
