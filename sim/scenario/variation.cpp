#include "sim/scenario/variation.h"

namespace eod::sim {
namespace {

/// SplitMix64 (Steele, Lea, Flood 2014): as good as this needs, and the same bits on any machine,
/// which the distributions of <random> do not promise.
class SplitMix {
 public:
  SplitMix(uint64_t seed, uint64_t stream) : state_(seed) { state_ = Next() ^ stream; }

  uint64_t Next() {
    state_ += 0x9e3779b97f4a7c15U;
    uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31);
  }
  /// Evenly within -1 .. 1, in steps of 2^-52: every one of them is exact.
  double Side() { return static_cast<double>(Next() >> 11) * 0x1p-52 - 1; }

 private:
  uint64_t state_;
};

void Move(SplitMix& random, Placement& place) {
  for (int axis = 0; axis < 3; ++axis) {
    // Drawn even where nothing is spread: other things do not move when one spread is edited.
    place.shift[axis] += random.Side() * place.spread[axis];
    place.spread[axis] = 0;
  }
}

}  // namespace

Scenario Vary(const Scenario& scenario, uint64_t repetition) {
  Scenario varied = scenario;
  varied.repetition = repetition;
  varied.lights.clear();
  if (repetition == 0) {
    varied.start.spread.setZero();
    for (Placement& place : varied.places) place.spread.setZero();
    if (!scenario.lights.empty()) varied.weather.light = scenario.lights.front();
    return varied;
  }
  SplitMix random(static_cast<uint64_t>(scenario.seed), repetition);
  varied.seed = static_cast<int64_t>(random.Next());
  const uint64_t light = random.Next();
  if (!scenario.lights.empty()) {
    varied.weather.light = scenario.lights[light % scenario.lights.size()];
  }
  Move(random, varied.start);
  for (Placement& place : varied.places) Move(random, place);
  return varied;
}

}  // namespace eod::sim
