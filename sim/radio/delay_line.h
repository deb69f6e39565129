#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "platform/time.h"
#include "sim/radio/link_random.h"
#include "sim/scenario/control_link_spec.h"

namespace eod::sim {

/// Directions of the link: each draws random numbers of its own.
enum class LinkStream : uint8_t { kCommands = 1, kTelemetry = 2, kPictures = 3 };

/// Messages on their way: each arrives after the delay and its jitter, or never. None overtakes
/// another. Memory is fixed: slots are filled and read in place, and keep what they hold.
template <typename Message>
class DelayLine {
 public:
  /// Room for `capacity` messages at a time; one more is lost.
  DelayLine(const TrafficSpec& spec, int64_t seed, LinkStream stream, size_t capacity)
      : spec_(spec),
        seed_(static_cast<uint64_t>(seed)),
        stream_(static_cast<uint64_t>(stream)),
        delay_(DurationOf(spec.delay)),
        slots_(capacity) {}

  /// A slot to be filled with a message that is sent at `now`; null if it gets lost. `drop`, 0..1:
  /// chance of that beside the line's own.
  Message* Send(TimePoint now, double drop = 0) {
    const uint64_t index = sent_++;
    const double loss = 1 - (1 - spec_.loss) * (1 - drop);
    if (LinkRandom(seed_, stream_, 2 * index) < loss || count_ == slots_.size()) {
      ++lost_;
      return nullptr;
    }
    const double jitter = spec_.jitter * LinkRandom(seed_, stream_, 2 * index + 1);
    last_due_ = std::max(last_due_, now + delay_ + DurationOf(jitter));
    Slot& slot = slots_[(first_ + count_++) % slots_.size()];
    slot.due = last_due_;
    return &slot.message;
  }

  /// The next message that has arrived by `now`, to be read before the next call; null if none has.
  const Message* Receive(TimePoint now) {
    if (count_ == 0 || slots_[first_].due > now) return nullptr;
    const Slot& slot = slots_[first_];
    arrived_ = slot.due;
    first_ = (first_ + 1) % slots_.size();
    --count_;
    return &slot.message;
  }
  /// When the message that was received last arrived.
  TimePoint arrived() const { return arrived_; }

  /// To get every slot its memory before the first message.
  template <typename Prepare>
  void ForEachSlot(Prepare prepare) {
    for (Slot& slot : slots_) prepare(slot.message);
  }

  uint64_t sent() const { return sent_; }
  uint64_t lost() const { return lost_; }

 private:
  struct Slot {
    TimePoint due{};
    Message message{};
  };
  static Duration DurationOf(double seconds) {
    return Duration(static_cast<Duration::rep>(seconds * 1e9 + 0.5));
  }

  TrafficSpec spec_;
  uint64_t seed_;
  uint64_t stream_;
  Duration delay_;
  std::vector<Slot> slots_;
  size_t first_ = 0;
  size_t count_ = 0;
  TimePoint last_due_{};
  TimePoint arrived_{};
  uint64_t sent_ = 0;
  uint64_t lost_ = 0;
};

}  // namespace eod::sim
