#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace eod::sim {

/// A line of a score sheet: what was counted or measured, and its points.
struct ScoreItem {
  std::string name;      ///< for machines: "collision", "stop_error"
  std::string text;      ///< for people
  bool is_taken = true;  ///< false: there is no measure yet
  double amount = 0;     ///< of `unit`
  std::string unit;      ///< "", "s", "m", "deg", "times par"
  double points = 0;     ///< gained, or lost if negative
  double of = 0;         ///< that can be gained; 0 where points can only be lost
  bool operator==(const ScoreItem&) const = default;
};

/// One of the five parts. Its points are the sum of its items', within 0 .. `of`; where items only
/// lose points they start from `of`.
struct ScorePart {
  std::string name;
  std::string text;
  double points = 0;
  double of = 0;
  std::vector<ScoreItem> items;
  bool operator==(const ScorePart&) const = default;
};

struct SheetEvent {
  double time_s = 0;  ///< of the mission
  std::string part;   ///< of ScorePart::name; "failure" for what failed the mission
  std::string name;   ///< of ScoreItem::name
  std::string text;
  double points = 0;
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< [m] of the robot, local
  bool operator==(const SheetEvent&) const = default;
};

struct SheetProcedure {
  std::string name;
  std::string text;
  std::string result;  ///< of ProcedureResult
  double time_s = -1;  ///< done or broken then; negative: not
  double points = 0;
  bool operator==(const SheetProcedure&) const = default;
};

/// A thing on the report's map.
struct SheetPlace {
  std::string name;
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< [m] local
  bool operator==(const SheetPlace&) const = default;
};

/// The itemised result of a mission. Plain data without a date: the same run gives the same sheet.
struct ScoreSheet {
  std::string scenario;
  std::string title;
  int module = 0;
  std::string module_name;
  int difficulty = 0;
  int64_t seed = 0;
  std::string result;            ///< "idle", "incomplete", "success", "fail" or "abort"
  std::string critical_failure;  ///< as the box names it: "rollover"; "" for none
  double elapsed_s = 0;
  double par_time_s = 0;
  int steps_done = 0;
  int steps = 0;
  double total = 0;
  double pass = 0;
  bool passed = false;  ///< succeeded, enough points, no critical failure
  double lost_s = 0;  ///< of the mission that the judge did not see: not the run's score if above 0
  std::array<ScorePart, 5> parts;
  std::vector<SheetProcedure> procedure;
  std::vector<SheetEvent> events;
  int events_left_out = 0;             ///< for want of room; their points count
  std::vector<Eigen::Vector2d> track;  ///< [m] of the robot, local
  std::vector<SheetPlace> places;
  bool operator==(const ScoreSheet&) const = default;
};

}  // namespace eod::sim
