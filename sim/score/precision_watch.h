#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/scenario/scenario.h"
#include "sim/score/score_event.h"
#include "sim/world/world_model.h"

namespace eod::sim {

/// One measure as it stands.
struct PrecisionState {
  bool is_taken = false;  ///< it has a value that counts
  double value = 0;       ///< SI, or a count
  double share = 0;       ///< 0..1 of its weight
};

/// Takes the measures that a scenario asks for. What has a moment of its own (stop, grasp, release,
/// coming over a rim) is taken then; the others when their step is complete, or all are.
class PrecisionWatch {
 public:
  /// Throws std::runtime_error that names the scenario's file for an object that is not in the
  /// module, is no drum or no movable where one is needed, and for a step that the scenario lacks.
  PrecisionWatch(const Scenario& scenario, const ModuleModel& module,
                 const std::vector<std::string>& names);
  void Reset();
  void Advance(const ScoreMoment& moment, EventList& events);

  size_t size() const { return measures_.size(); }
  const PrecisionSpec& spec(size_t index) const { return measures_[index].spec; }
  const PrecisionState& state(size_t index) const { return measures_[index].state; }
  /// 0..1 of the weights of all measures; none if there are none.
  std::optional<double> share() const;

 private:
  struct Measure {
    PrecisionSpec spec;
    std::vector<int> objects;      ///< in the module's names
    std::vector<size_t> movables;  ///< those of them that move
    VesselSpec vessel;
    Eigen::Vector2d target = Eigen::Vector2d::Zero();  ///< [m] of a placement
    PrecisionState state;
    double sum = 0;     ///< of what is averaged
    double weight = 0;  ///< of the sum: way, or number of values
    bool was_over = false;
    bool was_turning = false;
  };
  Measure MakeMeasure(const PrecisionSpec& spec, const Scenario& scenario,
                      const ModuleModel& module, const std::vector<std::string>& names) const;
  void AtItsMoment(const ScoreMoment& moment, Measure& measure);
  void Gather(const ScoreMoment& moment, Measure& measure) const;
  void Close(const ScoreMoment& moment, Measure& measure);
  void Take(Measure& measure, double value);

  std::vector<Measure> measures_;
  std::vector<TaskStep> steps_;
  uint32_t contacts_ = 0;
  bool was_held_ = false;
};

/// Distance [m] of a point from a polyline of at least one point.
double DistanceFrom(const std::vector<Eigen::Vector2d>& line, const Eigen::Vector2d& point);

}  // namespace eod::sim
