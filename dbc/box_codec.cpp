#include "dbc/box_codec.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "dbc/message_plan.h"
#include "dbc/roles.h"

namespace eod::dbc {
namespace {

[[noreturn]] void Fail(const ControlMap& map, int line, const std::string& text) {
  throw std::runtime_error(fmt::format("{}:{}: {}", map.file.string(), line, text));
}

/// All messages of one direction, by role.
template <typename State, typename MessageRole, int kCount>
class Direction {
 public:
  Direction(const Database& database, const ControlMap& map,
            std::span<const std::string_view> names, const std::vector<Role<State>>& roles,
            const std::map<std::string, MappedMessage>& messages,
            const std::map<std::string, MappedSignal>& signals) {
    CheckMessages(database, map, messages, roles, signals);
    for (size_t i = 0; i < plans_.size(); ++i) {
      const auto mapped = messages.find(std::string(names[i]));
      if (mapped == messages.end()) continue;
      plans_[i].emplace(database, map, mapped->second, roles, signals);
      senders_.push_back(FindMappedMessage(database, map, mapped->second).sender);
    }
    for (const Message& message : database.messages) {
      const bool is_ours = std::any_of(messages.begin(), messages.end(), [&](const auto& mapped) {
        return mapped.second.message == message.name;
      });
      if (is_ours || IsSender(message.sender)) ids_.emplace_back(message.id, message.extended);
    }
  }

  std::optional<CanFrame> Encode(MessageRole role, const State& state) {
    auto& plan = plans_[static_cast<size_t>(role)];
    if (!plan) return std::nullopt;
    return plan->Encode(state);
  }

  Received<MessageRole> Decode(const CanFrame& frame, State& state) {
    if (frame.remote || frame.error) return {};
    for (size_t i = 0; i < plans_.size(); ++i) {
      if (!plans_[i] || !plans_[i]->Matches(frame)) continue;
      return {plans_[i]->Decode(frame, state), static_cast<MessageRole>(i)};
    }
    return {};
  }

  Duration cycle_time(MessageRole role) const {
    const auto& plan = plans_[static_cast<size_t>(role)];
    return plan ? plan->cycle_time() : Duration{};
  }

  bool HasId(uint32_t id, bool extended) const {
    return std::find(ids_.begin(), ids_.end(), std::pair(id, extended)) != ids_.end();
  }

  bool IsSender(const std::string& node) const {
    return !node.empty() && node != "Vector__XXX" &&
           std::find(senders_.begin(), senders_.end(), node) != senders_.end();
  }
  const std::vector<std::string>& senders() const { return senders_; }

  uint64_t lost() const {
    uint64_t sum = 0;
    for (const auto& plan : plans_) sum += plan ? plan->lost() : 0;
    return sum;
  }
  void ResetSequences() {
    for (auto& plan : plans_) {
      if (plan) plan->ResetSequence();
    }
  }

 private:
  /// Every message in the DBC, none twice, and every signal in one of them.
  static void CheckMessages(const Database& database, const ControlMap& map,
                            const std::map<std::string, MappedMessage>& messages,
                            const std::vector<Role<State>>& roles,
                            const std::map<std::string, MappedSignal>& signals) {
    std::vector<std::string> used;
    for (const auto& [role, mapped] : messages) {
      FindMappedMessage(database, map, mapped);
      if (std::find(used.begin(), used.end(), mapped.message) != used.end()) {
        Fail(map, mapped.line,
             fmt::format("{} = \"{}\": the message has a role already", role, mapped.message));
      }
      used.push_back(mapped.message);
    }
    for (const auto& role : roles) {
      const MappedSignal& place = signals.at(role.name);
      if (place.message.empty()) continue;
      if (std::find(used.begin(), used.end(), place.message) != used.end()) continue;
      Fail(map, place.line,
           fmt::format("{} = \"{}.{}\": the message is not in [messages] of this direction",
                       role.key, place.message, place.signal));
    }
  }

  std::array<std::optional<MessagePlan<State>>, kCount> plans_;
  std::vector<std::string> senders_;
  std::vector<std::pair<uint32_t, bool>> ids_;
};

/// Controls and axes under the names of their roles.
std::map<std::string, MappedSignal> PanelSignals(const ControlMap& map) {
  std::map<std::string, MappedSignal> signals = map.controls;
  for (size_t a = 0; a < map.axes.size(); ++a) {
    signals["axis." + std::string(AxisNames()[a])] = map.axes[a].signal;
  }
  return signals;
}

}  // namespace

struct BoxCodec::Plans {
  Direction<PanelState, BoxMessage, kBoxMessageCount> box;
  Direction<RobotFeedback, RobotMessage, kRobotMessageCount> robot;
};

BoxCodec::BoxCodec(const Database& database, const ControlMap& map)
    : plans_(new Plans{
          {database, map, BoxMessageNames(), PanelRoles(), map.box_messages, PanelSignals(map)},
          {database, map, RobotMessageNames(), FeedbackRoles(), map.robot_messages,
           map.displays}}) {
  for (const std::string& sender : plans_->box.senders()) {
    if (!plans_->robot.IsSender(sender)) continue;
    Fail(map, 1, fmt::format("node {} sends messages of both the box and the robot", sender));
  }
}

BoxCodec::~BoxCodec() = default;
BoxCodec::BoxCodec(BoxCodec&&) noexcept = default;

std::optional<CanFrame> BoxCodec::Encode(BoxMessage role, const PanelState& panel) {
  return plans_->box.Encode(role, panel);
}

Received<RobotMessage> BoxCodec::Decode(const CanFrame& frame, RobotFeedback& feedback) {
  return plans_->robot.Decode(frame, feedback);
}

std::optional<CanFrame> BoxCodec::Encode(RobotMessage role, const RobotFeedback& feedback) {
  return plans_->robot.Encode(role, feedback);
}

Received<BoxMessage> BoxCodec::Decode(const CanFrame& frame, PanelState& panel) {
  return plans_->box.Decode(frame, panel);
}

Duration BoxCodec::cycle_time(BoxMessage role) const { return plans_->box.cycle_time(role); }
Duration BoxCodec::cycle_time(RobotMessage role) const { return plans_->robot.cycle_time(role); }

bool BoxCodec::IsRobotId(uint32_t id, bool extended) const {
  return plans_->robot.HasId(id, extended);
}
bool BoxCodec::IsBoxId(uint32_t id, bool extended) const { return plans_->box.HasId(id, extended); }

uint64_t BoxCodec::lost() const { return plans_->box.lost() + plans_->robot.lost(); }

void BoxCodec::ResetSequences() {
  plans_->box.ResetSequences();
  plans_->robot.ResetSequences();
}

}  // namespace eod::dbc
