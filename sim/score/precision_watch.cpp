#include "sim/score/precision_watch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>

#include "sim/disposal/charge.h"

namespace eod::sim {
namespace {

using Kind = PrecisionSpec::Kind;
constexpr double kDegree = std::numbers::pi / 180;

template <typename Named>
const Named* Find(const std::vector<Named>& list, const std::string& name) {
  const auto found = std::find_if(list.begin(), list.end(),
                                  [&name](const Named& one) { return one.name == name; });
  return found == list.end() ? nullptr : &*found;
}

double ShareOf(const PrecisionSpec& spec, double value) {
  return std::clamp((spec.worst - value) / (spec.worst - spec.best), 0.0, 1.0);
}

bool IsInBox(const PrecisionSpec& spec, const Eigen::Vector3d& p_M) {
  if (!spec.box) return true;
  const Eigen::Vector4d& box = *spec.box;
  return p_M.x() >= box[0] && p_M.x() <= box[2] && p_M.y() >= box[1] && p_M.y() <= box[3];
}

bool Includes(const std::vector<int>& objects, int object) {
  return objects.empty() || std::find(objects.begin(), objects.end(), object) != objects.end();
}

}  // namespace

double DistanceFrom(const std::vector<Eigen::Vector2d>& line, const Eigen::Vector2d& point) {
  double nearest = (point - line.front()).norm();
  for (size_t i = 1; i < line.size(); ++i) {
    const Eigen::Vector2d along = line[i] - line[i - 1];
    const double length2 = along.squaredNorm();
    const double share =
        length2 > 0 ? std::clamp((point - line[i - 1]).dot(along) / length2, 0.0, 1.0) : 0;
    nearest = std::min(nearest, (point - line[i - 1] - share * along).norm());
  }
  return nearest;
}

PrecisionWatch::PrecisionWatch(const Scenario& scenario, const ModuleModel& module,
                               const std::vector<std::string>& names)
    : steps_(scenario.steps) {
  for (const PrecisionSpec& spec : scenario.precision) {
    measures_.push_back(MakeMeasure(spec, scenario, module, names));
  }
}

PrecisionWatch::Measure PrecisionWatch::MakeMeasure(const PrecisionSpec& spec,
                                                    const Scenario& scenario,
                                                    const ModuleModel& module,
                                                    const std::vector<std::string>& names) const {
  const auto fail = [&](const std::string& what) {
    throw std::runtime_error(
        fmt::format("{}: precision '{}': {}", scenario.file.string(), NameOf(spec.kind), what));
  };
  Measure measure;
  measure.spec = spec;
  if (spec.step > static_cast<int>(steps_.size())) {
    fail(fmt::format("step = {}, but there are {}", spec.step, steps_.size()));
  }
  for (const std::string& object : spec.objects) {
    const auto found = std::lower_bound(names.begin(), names.end(), object);
    if (found == names.end() || *found != object) {
      fail(fmt::format("object '{}' is not in module {} ({})", object, module.id, module.name));
    }
    measure.objects.push_back(static_cast<int>(found - names.begin()));
    const MovableObject* movable = Find(module.movables, object);
    if (movable != nullptr) {
      measure.movables.push_back(static_cast<size_t>(movable - module.movables.data()));
    } else if (spec.kind == Kind::kMoved) {
      fail(fmt::format("object '{}' is no movable", object));
    }
  }
  if (spec.kind == Kind::kRimClearance || spec.kind == Kind::kReleaseOffset) {
    const VesselSpec* vessel = Find(module.vessels, spec.objects.front());
    const bool is_drum = vessel != nullptr && vessel->inner_radius > 0;
    if (!is_drum) fail(fmt::format("object '{}' is no drum", spec.objects.front()));
    measure.vessel = *vessel;
  }
  if (!spec.points.empty()) {
    measure.target = spec.points.front();
  } else if (!spec.objects.empty()) {
    const WorldObject* object = Find(module.objects, spec.objects.front());
    const MovableObject* movable = Find(module.movables, spec.objects.front());
    if (object != nullptr) measure.target = object->X_MO.translation().head<2>();
    if (movable != nullptr) measure.target = movable->X_MO.translation().head<2>();
  }
  return measure;
}

void PrecisionWatch::Reset() {
  for (Measure& measure : measures_) {
    measure.state = {};
    measure.sum = 0;
    measure.weight = 0;
    measure.was_over = false;
    measure.was_turning = false;
  }
  contacts_ = 0;
  was_held_ = false;
}

void PrecisionWatch::Take(Measure& measure, double value) {
  measure.state = {.is_taken = true, .value = value, .share = ShareOf(measure.spec, value)};
}

void PrecisionWatch::Advance(const ScoreMoment& moment, EventList& events) {
  const int steps = static_cast<int>(steps_.size());
  const int now = moment.now->mission_step;
  for (size_t i = 0; i < measures_.size(); ++i) {
    Measure& measure = measures_[i];
    const int step = measure.spec.step;
    if (step > 0 && moment.step_before != step - 1) continue;
    const PrecisionState before = measure.state;
    AtItsMoment(moment, measure);
    if (moment.step_before < steps) Gather(moment, measure);
    const bool ends = step > 0 ? now >= step : moment.step_before < steps && now == steps;
    if (ends) Close(moment, measure);
    const bool is_news =
        measure.state.is_taken && (!before.is_taken || before.value != measure.state.value);
    if (is_news) {
      events.Add(moment, ScoreMark::kMeasured, 0, static_cast<int>(i), -1, measure.state.value);
    }
  }
  contacts_ = moment.now->contact_parts;
  was_held_ = !moment.now->held_object.empty();
}

/// Measures that are taken when something happens.
void PrecisionWatch::AtItsMoment(const ScoreMoment& moment, Measure& measure) {
  const ScoreSample& now = *moment.now;
  const bool is_held = !now.held_object.empty();
  switch (measure.spec.kind) {
    case Kind::kStopError: {
      const auto step = static_cast<size_t>(moment.step_before);
      const bool stopped = now.mission_step > moment.step_before && step < steps_.size() &&
                           steps_[step].kind == TaskStep::Kind::kStopAt;
      if (!stopped) return;
      measure.sum += std::abs(now.ahead_m - steps_[step].distance);
      measure.weight += 1;
      Take(measure, measure.sum / measure.weight);
      return;
    }
    case Kind::kCentringError:
      if (is_held && !was_held_) Take(measure, std::abs(now.charge_in_hand.y()));
      return;
    case Kind::kReleaseOffset:
      if (was_held_ && !is_held) {
        Take(measure, (moment.charge_M - measure.vessel.X_MV.translation()).head<2>().norm());
      }
      return;
    case Kind::kRimClearance: {
      const bool is_over =
          is_held && IsWithinWalls(measure.vessel, measure.vessel.X_MV.inverse() * moment.charge_M);
      // The module's axes are the world's, and the rim is level.
      const double rim_W = now.position.z() - moment.p_M.z() +
                           measure.vessel.X_MV.translation().z() + measure.vessel.rim_z;
      if (is_over && !measure.was_over) Take(measure, now.charge_low_m - rim_W);
      measure.was_over = is_over;
      return;
    }
    default:
      return;
  }
}

/// What is gathered along the way.
void PrecisionWatch::Gather(const ScoreMoment& moment, Measure& measure) const {
  const ScoreSample& now = *moment.now;
  const PrecisionSpec& spec = measure.spec;
  const bool is_in_box = IsInBox(spec, moment.p_M);
  const bool is_turning = now.turn_rate_dps != 0;
  const bool begins_turn = is_turning && !measure.was_turning;
  measure.was_turning = is_turning;
  if (!is_in_box) return;
  const auto average = [&](double value) {
    measure.sum += value * moment.way;
    measure.weight += moment.way;
  };
  switch (spec.kind) {
    case Kind::kPathError:
      average(DistanceFrom(spec.points, moment.p_M.head<2>()));
      return;
    case Kind::kHeadingError: {
      const double off = now.heading_deg * kDegree - spec.heading;
      average(std::abs(std::remainder(off, 2 * std::numbers::pi)));
      return;
    }
    case Kind::kTiltPeak: {
      const Attitude attitude{
          .heading = 0, .pitch = now.pitch_deg * kDegree, .roll = now.roll_deg * kDegree};
      measure.sum = std::max(measure.sum, TiltOf(attitude));
      measure.weight = 1;
      return;
    }
    case Kind::kContacts:
      measure.weight = 1;
      if ((now.contact_parts & ~contacts_) != 0 && Includes(measure.objects, moment.contact)) {
        measure.sum += 1;
      }
      return;
    case Kind::kWallClearance: {
      const double distance = DistanceFrom(spec.points, moment.p_M.head<2>());
      measure.sum = measure.weight > 0 ? std::min(measure.sum, distance) : distance;
      measure.weight = 1;
      return;
    }
    case Kind::kTurnCount:
      measure.weight = 1;
      if (begins_turn) measure.sum += 1;
      return;
    default:
      return;
  }
}

/// What is known when the step, or all steps, are complete.
void PrecisionWatch::Close(const ScoreMoment& moment, Measure& measure) {
  const ScoreSample& now = *moment.now;
  switch (measure.spec.kind) {
    case Kind::kPathError:
    case Kind::kHeadingError:
    case Kind::kTiltPeak:
    case Kind::kWallClearance:
    case Kind::kContacts:
    case Kind::kTurnCount:
      if (measure.weight > 0) {
        const bool is_mean =
            measure.spec.kind == Kind::kPathError || measure.spec.kind == Kind::kHeadingError;
        Take(measure, is_mean ? measure.sum / measure.weight : measure.sum);
      }
      return;
    case Kind::kPlacementError:
      if (!now.charge.empty()) {
        Take(measure, (moment.charge_M.head<2>() - measure.target).norm());
      }
      return;
    case Kind::kMoved: {
      double farthest = 0;
      for (size_t i = 0; i < now.moved_m.size(); ++i) {
        const bool counts = measure.movables.empty() ||
                            std::find(measure.movables.begin(), measure.movables.end(), i) !=
                                measure.movables.end();
        if (counts) farthest = std::max(farthest, now.moved_m[i]);
      }
      Take(measure, farthest);
      return;
    }
    default:
      return;
  }
}

std::optional<double> PrecisionWatch::share() const {
  double all = 0, got = 0;
  for (const Measure& measure : measures_) {
    all += measure.spec.weight;
    got += measure.spec.weight * measure.state.share;
  }
  if (all == 0) return {};
  return got / all;
}

}  // namespace eod::sim
