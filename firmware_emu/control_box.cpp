#include "firmware_emu/control_box.h"

#include <algorithm>
#include <utility>

#include "firmware_emu/indicators.h"

namespace eod::box {

using dbc::BoxMessage;
using dbc::FrameVerdict;
using dbc::Lamp;
using dbc::LampPattern;

namespace {

bool IsEstopPressed(const dbc::PanelState& panel) { return !panel.estop_a || panel.estop_b; }

// What the robot must know before the next cyclic frame: anything about the e-stop, and an enabling
// switch that is no longer held.
bool IsSafetyEvent(const dbc::PanelState& before, const dbc::PanelState& after) {
  return before.estop_a != after.estop_a || before.estop_b != after.estop_b ||
         (before.deadman != after.deadman && after.deadman != dbc::Deadman::kEnabled);
}

}  // namespace

ControlBox::ControlBox(dbc::BoxCodec codec, const ControlBoxConfig& config)
    : config_(config), codec_(std::move(codec)), scanner_(config.scanner), schedule_(codec_) {
  frames_.reserve(size_t{2} * dbc::kBoxMessageCount);
}

std::span<const CanFrame> ControlBox::Tick(TimePoint now, const PanelInputs& inputs) {
  frames_.clear();
  AdvancePhase(now, inputs.powered);
  if (phase_ == Phase::kOff) return frames_;
  Report(now, inputs);
  SuperviseLink(now);
  UpdateEstopLatch();
  status_.state = FindState();
  Transmit(now);
  Show(now);
  return frames_;
}

void ControlBox::OnFrame(const CanFrame& frame, TimePoint now) {
  if (phase_ == Phase::kOff || phase_ == Phase::kBoot) return;
  const dbc::Received<dbc::RobotMessage> received = codec_.Decode(frame, status_.feedback);
  switch (received.verdict) {
    case FrameVerdict::kAccepted:
      ++status_.rx;
      last_rx_ = now;
      if (received.role == dbc::RobotMessage::kPose) status_.pose_time = now;
      status_.link_up = true;
      is_link_lost_ = false;
      return;
    case FrameVerdict::kWrongCrc:
      ++status_.crc_errors;
      return;
    case FrameVerdict::kRepeated:
    case FrameVerdict::kWrongSequence:
      ++status_.sequence_errors;
      return;
    case FrameVerdict::kWrongLength:
      ++status_.length_errors;
      return;
    case FrameVerdict::kUnknownId:
      ++status_.foreign_frames;
      return;
  }
}

void ControlBox::AdvancePhase(TimePoint now, bool powered) {
  if (!powered) {
    if (phase_ != Phase::kOff) PowerDown();
    return;
  }
  if (phase_ == Phase::kOff) EnterPhase(Phase::kBoot, now);
  if (phase_ == Phase::kBoot && now - phase_since_ >= config_.boot_time) {
    EnterPhase(Phase::kSelfTest, phase_since_ + config_.boot_time);
  }
  if (phase_ == Phase::kSelfTest && now - phase_since_ >= config_.self_test_time) {
    EnterPhase(Phase::kRunning, phase_since_ + config_.self_test_time);
  }
}

void ControlBox::EnterPhase(Phase phase, TimePoint since) {
  phase_ = phase;
  phase_since_ = since;
  if (phase == Phase::kBoot) {
    scanner_.PowerUp();
  } else if (phase == Phase::kSelfTest) {
    status_.reported.nmt = dbc::NmtState::kBootUp;
    Queue(BoxMessage::kHeartbeat);
    status_.reported.nmt = dbc::NmtState::kPreOperational;
    schedule_.StartHeartbeat(since);
  } else if (phase == Phase::kRunning) {
    scanner_.CheckNeutral();
    status_.reported.nmt = dbc::NmtState::kOperational;
    schedule_.StartProcessData(since);
    last_rx_ = std::max(last_rx_, since);
  }
}

// Counters stay: they count since the object was made. The display goes dark.
void ControlBox::PowerDown() {
  PanelStatus dark;
  dark.rx = status_.rx;
  dark.crc_errors = status_.crc_errors;
  dark.sequence_errors = status_.sequence_errors;
  dark.length_errors = status_.length_errors;
  dark.foreign_frames = status_.foreign_frames;
  dark.tx = status_.tx;
  dark.skipped = status_.skipped;
  dark.max_late = status_.max_late;
  status_ = dark;
  schedule_.StopAll();
  codec_.ResetSequences();
  phase_ = Phase::kOff;
  announced_fault_ = BoxFault::kNone;
  is_link_lost_ = is_estop_latched_ = false;
}

void ControlBox::Report(TimePoint now, const PanelInputs& inputs) {
  const dbc::PanelState before = status_.reported;
  status_.reported = scanner_.Scan(now, inputs);
  status_.fault = phase_ == Phase::kRunning ? FindFault() : BoxFault::kNone;
  status_.reported.box_fault = static_cast<int>(status_.fault);
  // CANopen: 0xFFxx is for the device's maker; register bits 0 (generic) and 7 (maker's own).
  const bool has_fault = status_.fault != BoxFault::kNone;
  status_.reported.error_code = has_fault ? 0xFF00 + static_cast<int>(status_.fault) : 0;
  status_.reported.error_register = has_fault ? 0x81 : 0;
  status_.reported.nmt = before.nmt;
  status_.reported.nonce_echo = status_.feedback.nonce;
  status_.reported.supply_v = config_.supply_v;
  status_.reported.variant = config_.variant;
  status_.reported.protocol_major = config_.protocol_major;
  is_safety_event_ = IsSafetyEvent(before, status_.reported);
}

BoxFault ControlBox::FindFault() const {
  if (scanner_.has_channel_fault()) return BoxFault::kEstopChannels;
  if (scanner_.has_stuck_control()) return BoxFault::kStuckControl;
  if (scanner_.has_axis_fault()) return BoxFault::kAxis;
  return BoxFault::kNone;
}

void ControlBox::SuperviseLink(TimePoint now) {
  if (phase_ != Phase::kRunning || is_link_lost_) return;
  if (now - last_rx_ <= config_.link_timeout) return;
  status_.link_up = false;
  is_link_lost_ = true;
  codec_.ResetSequences();
}

void ControlBox::UpdateEstopLatch() {
  if (IsEstopPressed(status_.reported)) {
    is_estop_latched_ = true;
  } else if (status_.reported.reset == dbc::Button::kPressed) {
    is_estop_latched_ = false;
  }
}

BoxState ControlBox::FindState() const {
  if (phase_ == Phase::kBoot) return BoxState::kBoot;
  if (phase_ == Phase::kSelfTest) return BoxState::kSelfTest;
  const dbc::SystemState robot = status_.link_up ? status_.feedback.state : dbc::SystemState::kInit;
  if (is_estop_latched_ || robot == dbc::SystemState::kEstopLatched) {
    return BoxState::kEstopLatched;
  }
  if (status_.fault != BoxFault::kNone) return BoxState::kFault;
  if (is_link_lost_) return BoxState::kLinkLost;
  if (status_.reported.key != dbc::KeySwitch::kOperate) return BoxState::kStandby;
  return robot == dbc::SystemState::kOperate ? BoxState::kOperate : BoxState::kReady;
}

void ControlBox::Transmit(TimePoint now) {
  const TransmitSchedule::Batch due = schedule_.TakeDue(now);
  if (phase_ == Phase::kRunning) {
    if (is_safety_event_ && !due.Contains(BoxMessage::kSafety)) Queue(BoxMessage::kSafety);
    if (status_.fault != announced_fault_) Queue(BoxMessage::kEmergency);
    announced_fault_ = status_.fault;
  }
  for (const BoxMessage role : due) Queue(role);
  status_.skipped = schedule_.skipped();
  status_.late = schedule_.late();
  status_.max_late = schedule_.max_late();
}

void ControlBox::Queue(BoxMessage role) {
  const std::optional<CanFrame> frame = codec_.Encode(role, status_.reported);
  if (!frame) return;
  frames_.push_back(*frame);
  ++status_.tx;
}

void ControlBox::Show(TimePoint now) {
  const dbc::BuzzerPattern previous = status_.buzzer;
  if (status_.link_up) {
    status_.lamp = status_.feedback.lamp;
    status_.buzzer = status_.feedback.buzzer;
  } else {
    ShowLocalLamps();
  }
  if (status_.buzzer != previous) buzzer_since_ = now;
  status_.is_sounding = IsSounding(status_.buzzer, now - buzzer_since_);
  const bool all_lit = phase_ == Phase::kSelfTest || status_.reported.lamp_test;
  for (int i = 0; i < dbc::kLampCount; ++i) {
    status_.lit[i] = all_lit || IsLit(status_.lamp[i], now);
  }
}

// Without a robot the box shows only what it knows itself; old news would deceive.
void ControlBox::ShowLocalLamps() {
  const auto show = [this](Lamp lamp, bool active, LampPattern pattern) {
    status_.lamp[static_cast<int>(lamp)] = active ? pattern : LampPattern::kOff;
  };
  status_.lamp.fill(LampPattern::kOff);
  show(Lamp::kPower, phase_ != Phase::kBoot, LampPattern::kOn);
  show(Lamp::kLink, is_link_lost_, LampPattern::kFastBlink);
  show(Lamp::kEstop, is_estop_latched_, LampPattern::kOn);
  show(Lamp::kFault, status_.fault != BoxFault::kNone, LampPattern::kOn);
  status_.buzzer = is_link_lost_ ? dbc::BuzzerPattern::kSlow : dbc::BuzzerPattern::kOff;
}

}  // namespace eod::box
