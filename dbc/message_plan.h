#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "dbc/box_codec.h"
#include "dbc/control_map.h"
#include "dbc/database.h"
#include "dbc/e2e.h"
#include "dbc/field_plan.h"
#include "dbc/roles.h"
#include "dbc/signal_plan.h"
#include "platform/can_frame.h"
#include "platform/time.h"

namespace eod::dbc {

/// Where a message has its end-to-end protection, by the DBC.
struct E2ePlan {
  uint16_t data_id = 0;
  int crc_byte = 0;
  SignalPlan crc;
  SignalPlan counter;
};

/// One field of State in one message.
template <typename State>
struct StateField {
  FieldPlan plan;
  int index;
  double (*get)(const State&, int index);
  void (*set)(State&, int index, double value);
};

/// One message of one direction: its frame, its fields of State, and its counters.
template <typename State>
class MessagePlan {
 public:
  /// Compiles the message and those `signals` of the map that are in it. Throws std::runtime_error
  /// "FILE:LINE: …" for what the DBC does not have.
  MessagePlan(const Database& database, const ControlMap& map, const MappedMessage& mapped,
              const std::vector<Role<State>>& roles,
              const std::map<std::string, MappedSignal>& signals);

  bool Matches(const CanFrame& frame) const {
    return frame.id == blank_.id && frame.extended == blank_.extended;
  }
  CanFrame Encode(const State& state);
  FrameVerdict Decode(const CanFrame& frame, State& state);

  Duration cycle_time() const { return cycle_time_; }
  uint64_t lost() const { return checker_.lost(); }
  void ResetSequence() { checker_.Reset(); }

 private:
  size_t length_ = 0;
  CanFrame blank_;  ///< frame with the start values of the signals that the map does not name
  Duration cycle_time_{};
  std::optional<E2ePlan> e2e_;
  std::vector<StateField<State>> fields_;
  int next_counter_ = 0;
  E2eChecker checker_;
};

extern template class MessagePlan<PanelState>;
extern template class MessagePlan<RobotFeedback>;

/// Finds the message that the map names. Throws "FILE:LINE: …" with the nearest name if there is
/// none.
const Message& FindMappedMessage(const Database& database, const ControlMap& map,
                                 const MappedMessage& mapped);

}  // namespace eod::dbc
