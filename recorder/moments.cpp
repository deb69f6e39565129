#include "recorder/moments.h"

#include <algorithm>
#include <utility>

namespace eod::recorder {
namespace {

constexpr double kSameMomentSeconds = 1.0;
constexpr double kApproachSeconds = 5.0;
constexpr double kNearAnEndSeconds = 8.0;
constexpr double kRecentPeriodSeconds = 0.25;
constexpr double kCompanionSeconds =
    0.2;  // pictures of two cameras this close show the same moment
constexpr size_t kMaxSamples = 64;

// Distance in time from `t` to the nearest of `moments`.
double Gap(const std::vector<Moment>& moments, double t) {
  double gap = 1e9;
  for (const Moment& moment : moments) gap = std::min(gap, std::abs(moment.t - t));
  return gap;
}

// Drops the moment that is closest to the one before it until `count` remain; first and last stay.
void ThinOut(std::vector<Moment>& moments, size_t count) {
  while (moments.size() > std::max<size_t>(count, 2)) {
    size_t closest = 1;
    for (size_t i = 1; i + 1 < moments.size(); ++i) {
      if (moments[i].t - moments[i - 1].t < moments[closest].t - moments[closest - 1].t) {
        closest = i;
      }
    }
    moments.erase(moments.begin() + static_cast<std::ptrdiff_t>(closest));
  }
  if (moments.size() > count) moments.resize(count);
}

void InsertByTime(std::vector<Moment>& moments, Moment moment) {
  const auto place = std::upper_bound(moments.begin(), moments.end(), moment.t,
                                      [](double t, const Moment& other) { return t < other.t; });
  moments.insert(place, std::move(moment));
}

}  // namespace

void Moments::Mark(double t, std::string label) {
  for (const Moment& mark : marks_) {
    if (std::abs(mark.t - t) < kSameMomentSeconds) return;
  }
  Moment mark;
  mark.t = t;
  mark.label = std::move(label);
  marks_.push_back(std::move(mark));
}

void Moments::MarkWithApproach(double t, std::string approach_label, std::string label) {
  const auto before = std::find_if(recent_.rbegin(), recent_.rend(), [t](const Moment& moment) {
    return moment.t <= t - kApproachSeconds;
  });
  // What lies before the last mark belongs to another story.
  const bool is_own = marks_.empty() || (before != recent_.rend() &&
                                         before->t >= marks_.back().t + kSameMomentSeconds);
  if (before != recent_.rend() && is_own) {
    Moment approach = *before;
    approach.label = std::move(approach_label);
    marks_.push_back(std::move(approach));
  }
  Mark(t, std::move(label));
}

void Moments::AddPicture(Camera camera, double t, const Jpeg& jpeg, const LampPatterns& lamps,
                         double speed_mps) {
  Moment caption;
  caption.t = t;
  caption.lamps = lamps;
  caption.speed_mps = speed_mps;
  FillMarks(camera, t, jpeg, caption);
  KeepSample(camera, t, jpeg, caption);
}

void Moments::FillMarks(Camera camera, double t, const Jpeg& jpeg, const Moment& caption) {
  for (Moment& mark : marks_) {
    if (mark.t > t || mark.pictures.contains(camera)) continue;
    // A camera that joined much later does not show this moment.
    if (!mark.pictures.empty() && t - mark.t > kSameMomentSeconds) continue;
    if (mark.pictures.empty()) {
      mark.t = t;
      mark.lamps = caption.lamps;
      mark.speed_mps = caption.speed_mps;
    }
    mark.pictures[camera] = jpeg;
  }
}

void Moments::KeepSample(Camera camera, double t, const Jpeg& jpeg, const Moment& caption) {
  // Pictures of the other camera complete the newest moment of each kind.
  const auto put = [&](Moment& moment) { moment.pictures[camera] = jpeg; };
  const auto completes = [&](const Moment& moment) {
    return t - moment.t < kCompanionSeconds && !moment.pictures.contains(camera);
  };

  if (!recent_.empty() && completes(recent_.back())) {
    put(recent_.back());
  } else if (recent_.empty() || t - recent_.back().t >= kRecentPeriodSeconds) {
    recent_.push_back(caption);
    put(recent_.back());
    while (recent_.back().t - recent_.front().t > kApproachSeconds + 4 * kRecentPeriodSeconds) {
      recent_.pop_front();
    }
  }

  if (!samples_.empty() && completes(samples_.back())) {
    put(samples_.back());
  } else if (samples_.empty() || t - samples_.back().t >= sample_period_s_) {
    samples_.push_back(caption);
    put(samples_.back());
    ThinSamples();
  }

  if (last_.pictures.empty() || !completes(last_)) {
    std::map<Camera, Jpeg> pictures = std::move(last_.pictures);
    last_ = caption;
    last_.pictures = std::move(pictures);
  }
  put(last_);
}

void Moments::ThinSamples() {
  if (samples_.size() <= kMaxSamples) return;
  // Drop every second one; keep the first.
  std::vector<Moment> kept;
  for (size_t i = 0; i < samples_.size(); i += 2) kept.push_back(std::move(samples_[i]));
  samples_ = std::move(kept);
  sample_period_s_ *= 2;
}

std::vector<Moment> Moments::Select(size_t count) const {
  std::vector<Moment> chosen;
  if (samples_.empty() || count == 0) return chosen;
  for (const Moment& mark : marks_) {
    if (!mark.pictures.empty()) InsertByTime(chosen, mark);
  }
  AddEnds(chosen);
  ThinOut(chosen, count);

  // Fill up with the sample that is farthest from all others, again and again.
  while (chosen.size() < count) {
    const auto farthest = std::ranges::max_element(
        samples_, {}, [&](const Moment& sample) { return Gap(chosen, sample.t); });
    if (Gap(chosen, farthest->t) < kSameMomentSeconds) break;
    InsertByTime(chosen, *farthest);
  }
  return chosen;
}

void Moments::AddEnds(std::vector<Moment>& chosen) const {
  if (Gap(chosen, samples_.front().t) >= kNearAnEndSeconds) {
    InsertByTime(chosen, samples_.front());
    chosen.front().label = "First picture";
  }
  const double near = chosen.size() > 1 ? kNearAnEndSeconds : kSameMomentSeconds;
  if (Gap(chosen, last_.t) >= near) {
    InsertByTime(chosen, last_);
    chosen.back().label = "End";
  }
}

}  // namespace eod::recorder
