#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "sim/rules/score_rules.h"
#include "sim/scenario/scenario.h"
#include "sim/score/score_event.h"

namespace eod::sim {

/// How an item of the check list stands.
enum class ProcedureResult : uint8_t { kOpen, kDone, kOutOfOrder, kMissing, kKept, kBroken };

/// "open", "done", "out of order", "missing", "kept", "broken".
std::string_view NameOf(ProcedureResult result);

struct ProcedureState {
  ProcedureResult result = ProcedureResult::kOpen;
  double time_s = -1;  ///< when it was done or broken; negative: not
};

/// Ticks the items of the check list off. Those that are done once are out of order if one above
/// them was done later, and missing if they are not done in time.
class ProcedureWatch {
 public:
  ProcedureWatch(const Scenario& scenario, const ScoreRules& rules);
  void Reset();
  void Advance(const ScoreMoment& moment, EventList& events);
  /// The mission is over: what is open now is missing, or kept.
  void Finish(const ScoreMoment& moment, EventList& events);

  size_t size() const { return items_.size(); }
  const ProcedureSpec& spec(size_t index) const { return items_[index].spec; }
  const ProcedureState& state(size_t index) const { return items_[index].state; }
  /// Items missing, out of order or broken.
  int failed() const { return failed_; }

 private:
  struct Item {
    ProcedureSpec spec;
    ProcedureState state;
  };
  /// Whether what the item asks for has happened by now.
  bool IsDone(const ProcedureSpec& spec, const ScoreMoment& moment) const;
  bool IsBroken(const ProcedureSpec& spec, const ScoreMoment& moment) const;
  void NoteCameras(const ScoreMoment& moment);
  void BlameEarlierOnesBelow(size_t i, const ScoreMoment& moment, EventList& events);
  void Fail(size_t item, ProcedureResult result, const ScoreMoment& moment, EventList& events);

  std::vector<Item> items_;
  ScoreRules rules_;
  int failed_ = 0;
  uint32_t cameras_ = 0;  ///< looked through since the start, bits 1..4
  bool grasps_ = false;   ///< the first grasp, in this step
  bool has_grasped_ = false;
  bool fires_ = false;  ///< the first shot, in this step
  bool has_fired_ = false;
  bool has_honked_ = false;
  double carried_out_ = 0;  ///< [m] driven with a charge that is not drawn in
};

}  // namespace eod::sim
