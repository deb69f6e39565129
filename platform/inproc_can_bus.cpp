#include "platform/inproc_can_bus.h"

#include <map>
#include <utility>
#include <vector>

#include "platform/can_filter.h"

namespace eod {
namespace {

class InprocCanBus;

}  // namespace

/// What the nodes of one bus have in common. They own it together.
class InprocCanHub::Wire {
 public:
  explicit Wire(std::string name) : url_("inproc:" + std::move(name)) {}

  void Attach(InprocCanBus& node) { nodes_.push_back(&node); }
  void Detach(InprocCanBus& node) { std::erase(nodes_, &node); }
  void Deliver(const CanFrame& frame, const InprocCanBus& sender);
  void SetState(CanBusState state);

  CanBusState state() const { return state_; }
  uint64_t restarts() const { return restarts_; }
  const std::string& url() const { return url_; }

 private:
  std::string url_;
  std::vector<InprocCanBus*> nodes_;
  CanBusState state_ = CanBusState::kUp;
  uint64_t restarts_ = 0;
};

namespace {

class InprocCanBus final : public CanBus {
 public:
  InprocCanBus(std::shared_ptr<InprocCanHub::Wire> wire, const Clock& clock)
      : wire_(std::move(wire)), clock_(clock), restarts_before_(wire_->restarts()) {
    wire_->Attach(*this);
  }
  ~InprocCanBus() override { wire_->Detach(*this); }

  SendOutcome Send(const CanFrame& frame) override {
    if (wire_->state() != CanBusState::kUp || frame.error || !IsWellFormed(frame)) {
      ++counters_.tx_dropped;
      return SendOutcome::kDropped;
    }
    CanFrame sent = frame;
    sent.stamp = clock_.Now();
    wire_->Deliver(sent, *this);
    ++counters_.tx;
    return SendOutcome::kSent;
  }

  std::optional<CanFrame> Receive() override {
    if (next_ == waiting_.size()) return {};
    const CanFrame frame = waiting_[next_++];
    ++counters_.rx;
    // The queue keeps its memory: no allocation per frame once it has grown to its usual length.
    if (next_ == waiting_.size() || next_ == kInprocQueueLength) {
      waiting_.erase(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(next_));
      next_ = 0;
    }
    return frame;
  }

  void Accept(const CanFrame& frame) {
    if (!IsAccepted(filters_, frame)) return;
    if (waiting_.size() - next_ >= kInprocQueueLength) {
      ++counters_.rx_lost;
    } else {
      waiting_.push_back(frame);
    }
  }

  int PollDescriptor() const override { return -1; }
  void Maintain(TimePoint /*now*/) override {}
  void SetFilters(std::span<const CanFilter> filters) override {
    filters_.assign(filters.begin(), filters.end());
  }
  CanBusState state() const override { return wire_->state(); }
  CanBusCounters counters() const override {
    CanBusCounters counters = counters_;
    counters.restarts = wire_->restarts() - restarts_before_;
    return counters;
  }
  const std::string& url() const override { return wire_->url(); }

 private:
  std::shared_ptr<InprocCanHub::Wire> wire_;
  const Clock& clock_;
  std::vector<CanFilter> filters_;
  std::vector<CanFrame> waiting_;  ///< from next_ on
  size_t next_ = 0;
  CanBusCounters counters_;
  uint64_t restarts_before_;
};

}  // namespace

void InprocCanHub::Wire::Deliver(const CanFrame& frame, const InprocCanBus& sender) {
  for (InprocCanBus* node : nodes_) {
    if (node != &sender) node->Accept(frame);
  }
}

void InprocCanHub::Wire::SetState(CanBusState state) {
  if (state == CanBusState::kUp && state_ != CanBusState::kUp) ++restarts_;
  state_ = state;
}

InprocCanHub::InprocCanHub(std::string name) : wire_(std::make_shared<Wire>(std::move(name))) {}

std::unique_ptr<CanBus> InprocCanHub::Connect(const Clock& clock) {
  return std::make_unique<InprocCanBus>(wire_, clock);
}

void InprocCanHub::SetState(CanBusState state) { wire_->SetState(state); }

std::unique_ptr<CanBus> OpenInprocCanBus(const std::string& name, const Clock& clock) {
  // By name, a bus lives as long as a node of it does.
  static std::map<std::string, std::weak_ptr<InprocCanHub::Wire>> wires;
  std::shared_ptr<InprocCanHub::Wire> wire = wires[name].lock();
  if (!wire) wires[name] = wire = std::make_shared<InprocCanHub::Wire>(name);
  return std::make_unique<InprocCanBus>(std::move(wire), clock);
}

}  // namespace eod
