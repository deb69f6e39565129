#include "sim/isectors/isector.h"

#include <cmath>

#include <fmt/format.h>

#include "sim/geometry/pose.h"

namespace eod::sim {

namespace {

constexpr double kUnitTolerance = 1e-6;

std::string StaleText(const std::string& what, int64_t asked, int64_t cast) {
  const std::string last =
      cast == Isector::kNever ? "was never cast" : fmt::format("was last cast in step {}", cast);
  return fmt::format("isector {}: read in step {}, but it {}", what, asked, last);
}

void CheckLength(const std::string& name, double length) {
  if (std::isfinite(length) && length >= 0) return;
  throw std::invalid_argument(
      fmt::format("isector {}: length {} m, needs 0 or more", name, length));
}

void CheckLine(const std::string& name, const IsectorSegment& line) {
  CheckLength(name, line.length);
  const double norm = line.direction.norm();
  if (std::abs(norm - 1) <= kUnitTolerance) return;
  throw std::invalid_argument(
      fmt::format("isector {}: a direction of length {}, needs 1", name, norm));
}

}  // namespace

StaleReading::StaleReading(const std::string& what, int64_t asked, int64_t cast)
    : std::logic_error(StaleText(what, asked, cast)), asked_(asked), cast_(cast) {}

Isector::Isector(std::string name, IsectorMethod method, std::vector<IsectorSegment> segments)
    : name_(std::move(name)),
      method_(method),
      segments_(std::move(segments)),
      class_mask_(UsualClasses(method)),
      hit_rule_(LooksForGround(method) ? HitRule::kHighest : HitRule::kNearest),
      results_(segments_.size()) {
  const auto [fewest, most] = SegmentCountOf(method);
  if (segments_.size() < fewest || segments_.size() > most) {
    throw std::invalid_argument(fmt::format("isector {}: {} segments, method {} has {}..{}", name_,
                                            segments_.size(), NameOf(method), fewest, most));
  }
  for (const IsectorSegment& segment : segments_) CheckLine(name_, segment);
  if (method == IsectorMethod::kTripod &&
      StandInOneLine(segments_[0].start, segments_[1].start, segments_[2].start)) {
    throw std::invalid_argument(fmt::format("isector {}: its legs stand in one line", name_));
  }
}

void Isector::RequireMethod(IsectorMethod method) const {
  if (method == method_) return;
  throw std::invalid_argument(
      fmt::format("isector {}: method {}, read as {}", name_, NameOf(method_), NameOf(method)));
}

void Isector::SetLength(int segment, double metres) {
  CheckLength(name_, metres);
  segments_.at(segment).length = metres;
}

void Isector::SetSegment(int segment, const IsectorSegment& line) {
  CheckLine(name_, line);
  segments_.at(segment) = line;
}

Eigen::Isometry3d Isector::SegmentFrame() const {
  Eigen::Isometry3d X_MS = X_MI_;
  if (LooksForGround(method_)) {
    X_MS.linear() = ToRotation({.heading = ToAttitude(X_MI_.linear()).heading});
  }
  return X_MS;
}

SegmentQuery Isector::QueryOf(const IsectorSegment& segment, const Eigen::Isometry3d& X_MS) const {
  return {.start = X_MS * segment.start,
          .direction = X_MS.linear() * segment.direction,
          .length = segment.length,
          .class_mask = class_mask_,
          .hit_rule = hit_rule_,
          .face_rule = face_rule_};
}

void Isector::BeginStep(int64_t step) {
  cast_step_ = step;
  X_MI_of_cast_ = X_MI_;
  listed_.clear();
}

void Isector::Take(int segment, const SegmentHit& hit, std::span<const ListedHit> listed) {
  results_[segment] = {.step = cast_step_,
                       .hit = hit,
                       .is_list = hit_rule_ == HitRule::kAll,
                       .first_listed = listed_.size(),
                       .listed = listed.size()};
  for (const ListedHit& entry : listed) listed_.push_back(entry.hit);
}

const SegmentHit& Isector::Hit(int segment, int64_t step) const {
  const Result& result = results_.at(segment);
  if (result.step != step) {
    throw StaleReading(fmt::format("{} segment {}", name_, segment), step, result.step);
  }
  return result.hit;
}

std::span<const SegmentHit> Isector::AllHits(int segment, int64_t step) const {
  Hit(segment, step);
  const Result& result = results_[segment];
  if (result.is_list) return std::span(listed_).subspan(result.first_listed, result.listed);
  return {&result.hit, result.hit.hit ? size_t{1} : size_t{0}};
}

const Eigen::Isometry3d& Isector::PoseOfCast(int64_t step) const {
  if (cast_step_ != step) throw StaleReading(name_, step, cast_step_);
  return X_MI_of_cast_;
}

}  // namespace eod::sim
