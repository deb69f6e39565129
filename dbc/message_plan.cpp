#include "dbc/message_plan.h"

#include <algorithm>
#include <charconv>
#include <stdexcept>

#include <fmt/format.h>

#include "dbc/nearest_name.h"

namespace eod::dbc {
namespace {

constexpr uint32_t kStandardIds = 0x7FF;

[[noreturn]] void Fail(const ControlMap& map, int line, const std::string& text) {
  throw std::runtime_error(fmt::format("{}:{}: {}", map.file.string(), line, text));
}

template <typename Named>
std::string NearestOf(std::string_view name, const std::vector<Named>& candidates) {
  std::vector<std::string> names;
  names.reserve(candidates.size());
  for (const Named& candidate : candidates) names.push_back(candidate.name);
  return NearestName(name, names);
}

const Signal& FindMappedSignal(const Message& message, const ControlMap& map,
                               const MappedSignal& mapped, const std::string& role) {
  const Signal* signal = message.FindSignal(mapped.signal);
  if (signal != nullptr) return *signal;
  Fail(map, mapped.line,
       fmt::format("{} = \"{}.{}\": the message has no such signal; did you mean \"{}\"?", role,
                   mapped.message, mapped.signal, NearestOf(mapped.signal, message.signals)));
}

/// What a frame of the message looks like before any field is written.
CanFrame BlankFrame(const Message& message, const ControlMap& map, int line) {
  const bool is_fd_length = message.length <= 8 || message.length == 12 || message.length == 16 ||
                            message.length == 20 || message.length == 24 || message.length == 32 ||
                            message.length == 48 || message.length == 64;
  if (!is_fd_length) {
    Fail(map, line,
         fmt::format("message {} has {} bytes; CAN FD has 0..8, 12, 16, 20, 24, 32, 48, 64",
                     message.name, message.length));
  }
  if (!message.extended && message.id > kStandardIds) {
    Fail(map, line,
         fmt::format("message {}: id 0x{:X} has more than 11 bits; set bit 31 in the DBC "
                     "if it is an extended one",
                     message.name, message.id));
  }
  CanFrame frame;
  frame.id = message.id;
  frame.extended = message.extended;
  frame.fd = message.is_fd();
  const auto switched = message.attributes.find("CANFD_BRS");
  frame.bit_rate_switch =
      frame.fd && switched != message.attributes.end() && switched->second != "0";
  frame.length = static_cast<uint8_t>(message.length);
  return frame;
}

/// Start value of a signal, raw, as the DBC gives it.
std::optional<int64_t> StartValue(const Signal& signal) {
  const auto found = signal.attributes.find("GenSigStartValue");
  if (found == signal.attributes.end() || signal.is_multiplexed()) return std::nullopt;
  int64_t raw = 0;
  const std::string& text = found->second;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), raw);
  if (error != std::errc()) return std::nullopt;
  return raw;
}

std::optional<E2ePlan> CompileE2e(const Message& message, const ControlMap& map, int line) {
  const auto data_id = message.e2e_data_id();
  const Signal* crc = message.FindSignal(map.crc_signal);
  const Signal* counter = message.FindSignal(map.counter_signal);
  if (!data_id && crc == nullptr) return std::nullopt;
  if (!data_id || crc == nullptr || counter == nullptr) {
    Fail(map, line,
         fmt::format("message {}: end-to-end protection needs all of signal {}, signal {}, and an "
                     "E2EDataId other than 0",
                     message.name, map.crc_signal, map.counter_signal));
  }
  const bool is_whole_byte = crc->length == 8 && !crc->is_signed &&
                             crc->start_bit % 8 == (crc->byte_order == ByteOrder::kIntel ? 0 : 7);
  if (!is_whole_byte || counter->length < 4 || counter->is_signed) {
    Fail(map, line,
         fmt::format("message {}: {} must be one whole byte, {} 4 bit or more, unsigned",
                     message.name, crc->name, counter->name));
  }
  return E2ePlan{*data_id, crc->start_bit / 8, SignalPlan(*crc, message.length),
                 SignalPlan(*counter, message.length)};
}

/// The bits that each signal occupies, to find two signals of the map in one place.
class Occupied {
 public:
  explicit Occupied(size_t length) : bits_(length) {}

  /// False if one of the signal's bits is taken already.
  bool Take(const Signal& signal) {
    std::vector<uint8_t> own(bits_.size());
    SignalPlan(signal, static_cast<int>(own.size())).EncodeRaw(-1, own);
    bool is_free = true;
    for (size_t i = 0; i < own.size(); ++i) {
      is_free = is_free && (bits_[i] & own[i]) == 0;
      bits_[i] |= own[i];
    }
    return is_free;
  }

 private:
  std::vector<uint8_t> bits_;
};

FrameVerdict VerdictOf(E2eStatus status) {
  switch (status) {
    case E2eStatus::kInitial:
    case E2eStatus::kOk:
    case E2eStatus::kOkSomeLost:
      return FrameVerdict::kAccepted;
    case E2eStatus::kRepeated:
      return FrameVerdict::kRepeated;
    case E2eStatus::kWrongCrc:
      return FrameVerdict::kWrongCrc;
    case E2eStatus::kWrongSequence:
    case E2eStatus::kSync:
      break;
  }
  return FrameVerdict::kWrongSequence;
}

}  // namespace

const Message& FindMappedMessage(const Database& database, const ControlMap& map,
                                 const MappedMessage& mapped) {
  const Message* message = database.FindMessage(mapped.message);
  if (message != nullptr) return *message;
  Fail(map, mapped.line,
       fmt::format("{} has no message \"{}\"; did you mean \"{}\"?", database.file.string(),
                   mapped.message, NearestOf(mapped.message, database.messages)));
}

template <typename State>
MessagePlan<State>::MessagePlan(const Database& database, const ControlMap& map,
                                const MappedMessage& mapped, const std::vector<Role<State>>& roles,
                                const std::map<std::string, MappedSignal>& signals) {
  const Message& message = FindMappedMessage(database, map, mapped);
  length_ = static_cast<size_t>(message.length);
  blank_ = BlankFrame(message, map, mapped.line);
  cycle_time_ = std::chrono::milliseconds(message.cycle_time_ms());
  e2e_ = CompileE2e(message, map, mapped.line);

  const std::span<uint8_t> payload{blank_.data.data(), length_};
  for (const Signal& signal : message.signals) {
    if (const auto raw = StartValue(signal)) {
      SignalPlan(signal, message.length).EncodeRaw(*raw, payload);
    }
  }
  Occupied occupied(length_);
  if (e2e_) {
    occupied.Take(*message.FindSignal(map.crc_signal));
    occupied.Take(*message.FindSignal(map.counter_signal));
  }
  for (const Role<State>& role : roles) {
    const MappedSignal& place = signals.at(role.name);
    if (place.message != mapped.message) continue;
    const Signal& signal = FindMappedSignal(message, map, place, role.key);
    try {
      fields_.push_back(
          {FieldPlan(role, place, signal, message.length), role.index, role.get, role.set});
    } catch (const std::runtime_error& error) {
      Fail(map, place.line, fmt::format("{}: {}", role.key, error.what()));
    }
    if (!occupied.Take(signal)) {
      Fail(map, place.line,
           fmt::format("{} = \"{}.{}\": its bits are those of another signal of the map", role.key,
                       place.message, place.signal));
    }
  }
}

template <typename State>
CanFrame MessagePlan<State>::Encode(const State& state) {
  CanFrame frame = blank_;
  const std::span<uint8_t> payload{frame.data.data(), length_};
  for (const auto& field : fields_) field.plan.Encode(field.get(state, field.index), payload);
  if (e2e_) {
    e2e_->counter.EncodeRaw(next_counter_, payload);
    e2e_->crc.EncodeRaw(E2eCrc(e2e_->data_id, payload, e2e_->crc_byte), payload);
    next_counter_ = (next_counter_ + 1) % kE2eCounterCount;
  }
  return frame;
}

template <typename State>
FrameVerdict MessagePlan<State>::Decode(const CanFrame& frame, State& state) {
  if (frame.length < length_) return FrameVerdict::kWrongLength;
  const std::span<const uint8_t> payload{frame.data.data(), length_};
  if (e2e_) {
    const bool crc_ok =
        e2e_->crc.DecodeRaw(payload) == E2eCrc(e2e_->data_id, payload, e2e_->crc_byte);
    const auto counter = static_cast<int>(e2e_->counter.DecodeRaw(payload));
    const FrameVerdict verdict = VerdictOf(checker_.Check(crc_ok, counter));
    if (verdict != FrameVerdict::kAccepted) return verdict;
  }
  for (const auto& field : fields_) field.set(state, field.index, field.plan.Decode(payload));
  return FrameVerdict::kAccepted;
}

template class MessagePlan<PanelState>;
template class MessagePlan<RobotFeedback>;

}  // namespace eod::dbc
