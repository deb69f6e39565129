#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "dbc/robot_feedback.h"
#include "recorder/observations.h"

namespace eod::recorder {

using LampPatterns = std::array<dbc::LampPattern, dbc::kLampCount>;
using Jpeg = std::vector<uint8_t>;

/// A moment of the run worth a picture, with what the caption says.
struct Moment {
  double t = 0;       ///< [s] since the first robot state
  std::string label;  ///< empty for one that only fills a gap
  LampPatterns lamps{};
  double speed_mps = 0;
  std::map<Camera, Jpeg> pictures;
};

/// Keeps a few pictures of a run: those of marked moments, the one shortly before a mark, the
/// first, the last, and some in between. Memory stays bounded, however long the run.
class Moments {
 public:
  /// Marks `t`: the next picture of each camera at or after it is kept. A mark within a second of
  /// an earlier one is the same moment and is dropped.
  void Mark(double t, std::string label);
  /// Also keeps the picture of five seconds before `t`, when it was still ahead, unless another
  /// mark came since.
  void MarkWithApproach(double t, std::string approach_label, std::string label);

  void AddPicture(Camera camera, double t, const Jpeg& jpeg, const LampPatterns& lamps,
                  double speed_mps);

  /// At most `count` moments in the order of time: first, last and marks, then evenly spread
  /// others.
  std::vector<Moment> Select(size_t count) const;

 private:
  void FillMarks(Camera camera, double t, const Jpeg& jpeg, const Moment& caption);
  void KeepSample(Camera camera, double t, const Jpeg& jpeg, const Moment& caption);
  void ThinSamples();
  void AddEnds(std::vector<Moment>& chosen) const;

  std::vector<Moment> marks_;
  std::deque<Moment> recent_;    ///< the last seconds, for what comes before a mark
  std::vector<Moment> samples_;  ///< regular ones over the whole run
  double sample_period_s_ = 1;
  Moment last_;
};

}  // namespace eod::recorder
