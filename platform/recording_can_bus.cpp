#include "platform/recording_can_bus.h"

#include <utility>

namespace eod {

RecordingCanBus::RecordingCanBus(std::unique_ptr<CanBus> bus, CandumpWriter log, const Clock& clock)
    : bus_(std::move(bus)), log_(std::move(log)), clock_(clock) {}

SendOutcome RecordingCanBus::Send(const CanFrame& frame) {
  const SendOutcome outcome = bus_->Send(frame);
  if (outcome == SendOutcome::kSent) {
    CanFrame sent = frame;
    sent.stamp = clock_.Now();
    log_.Write(sent);
  }
  return outcome;
}

std::optional<CanFrame> RecordingCanBus::Receive() {
  const std::optional<CanFrame> frame = bus_->Receive();
  if (frame) log_.Write(*frame);
  return frame;
}

}  // namespace eod
