#pragma once

#include <string>
#include <string_view>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/scenario/mission.h"

namespace eod::lockstep {

/// Text of an operator script that switches the box on and enters a module ("slope").
inline std::string PowerUp(std::string_view module) {
  return fmt::format(
      "wait state standby within 3s\nkey operate\ndeadman enabled\nwait link up within 5s\n"
      "reset\nstart\nwait robot operate within 3s\n"
      "menu module {0}\nmenu start\nwait module {0} within 5s\n",
      module);
}

/// Turns on the spot to a heading [deg], 1..359, and stands; the last degrees slowly.
inline std::string TurnTo(double heading_deg, bool left) {
  const double sign = left ? -1 : 1;
  const std::string_view compare = left ? ">=" : "<=";
  return fmt::format(
      "hold {0} until heading {1} {2} within 15s\nspeed_limit 10%\n"
      "hold {0} until heading {1} {3} within 10s\nspeed_limit 100%\nwait 300ms\n",
      left ? "M03" : "M04", compare, heading_deg + sign * 12, heading_deg + sign * 0.25);
}

/// Forward [m] at high speed, the last 0.4 m at low and creep, and stands.
inline std::string DriveAhead(double metres) {
  std::string text;
  if (metres > 1) {
    text += fmt::format("speed high\nhold M01 until travel >= {} within 120s\n", metres - 0.75);
    metres = 0.75;  // its run-out counted in
  }
  return text +
         fmt::format("speed creep\nhold M01 until travel >= {} within 60s\nwait 500ms\n", metres);
}

/// The script comes to its end within `limit`, and finds all that it expects.
inline void PlayScript(Mission& mission, Duration limit) {
  ASSERT_TRUE(mission.Run(limit));
  EXPECT_EQ(mission.box().script_failure(), std::nullopt);
}

inline Mission RunMission(const std::string& text, const std::string& scenario) {
  return Mission(box::ParseScript(text, "test.boxscript"), ShippedScenario(scenario));
}

}  // namespace eod::lockstep
