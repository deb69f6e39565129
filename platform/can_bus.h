#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "platform/can_frame.h"
#include "platform/time.h"

namespace eod {

enum class CanBusState { kUp, kDown, kBusOff };

/// What became of a frame handed to `Send`.
enum class SendOutcome {
  kSent,
  kDropped,  ///< bus down, bus-off or no buffer: counted, never retried later (a stale command is
             ///< worse)
};

/// Counters since the bus was opened.
struct CanBusCounters {
  uint64_t rx = 0;            ///< data and remote frames received
  uint64_t tx = 0;            ///< frames sent
  uint64_t rx_lost = 0;       ///< frames that the receiver's queue lost
  uint64_t tx_dropped = 0;    ///< frames that the bus did not take
  uint64_t error_frames = 0;  ///< error reports of the controller
  uint64_t malformed = 0;     ///< datagrams or frames that were not CAN
  uint64_t restarts = 0;      ///< times the bus came back
};

/// Accepts frames with (id & mask) == (this->id & mask) of the same kind.
struct CanFilter {
  uint32_t id = 0;
  uint32_t mask = 0;
  bool extended = false;
};

/// A CAN bus that one node is connected to. A node never receives what it sent itself; every other
/// node of the bus receives it, in the order of sending.
class CanBus {
 public:
  virtual ~CanBus() = default;

  /// Never blocks and never throws; a frame that cannot go out now is dropped and counted.
  virtual SendOutcome Send(const CanFrame& frame) = 0;

  /// Next waiting frame, or nothing. Never blocks. Error frames are counted, not returned.
  virtual std::optional<CanFrame> Receive() = 0;

  /// Descriptor that polls readable when `Receive` may have a frame; -1 if there is none
  /// (in-process).
  virtual int PollDescriptor() const = 0;

  /// Brings the bus back after its interface went away. To be called at least every 100 ms.
  virtual void Maintain(TimePoint now) = 0;

  /// Receives only what one of `filters` accepts; an empty list accepts everything.
  virtual void SetFilters(std::span<const CanFilter> filters) = 0;

  virtual CanBusState state() const = 0;
  virtual CanBusCounters counters() const = 0;
  virtual const std::string& url() const = 0;
};

}  // namespace eod
