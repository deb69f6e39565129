#pragma once

#include <memory>

#include "platform/can_bus.h"
#include "platform/candump_log.h"
#include "platform/clock.h"

namespace eod {

/// Passes everything through to `bus` and writes each frame, sent or received, to `log` in the
/// order in which this node saw them.
class RecordingCanBus final : public CanBus {
 public:
  RecordingCanBus(std::unique_ptr<CanBus> bus, CandumpWriter log, const Clock& clock);

  SendOutcome Send(const CanFrame& frame) override;
  std::optional<CanFrame> Receive() override;
  int PollDescriptor() const override { return bus_->PollDescriptor(); }
  void Maintain(TimePoint now) override { bus_->Maintain(now); }
  void SetFilters(std::span<const CanFilter> filters) override { bus_->SetFilters(filters); }
  CanBusState state() const override { return bus_->state(); }
  CanBusCounters counters() const override { return bus_->counters(); }
  const std::string& url() const override { return bus_->url(); }

 private:
  std::unique_ptr<CanBus> bus_;
  CandumpWriter log_;
  const Clock& clock_;
};

}  // namespace eod
