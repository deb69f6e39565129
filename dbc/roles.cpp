#include "dbc/roles.h"

#include <cmath>
#include <limits>
#include <type_traits>

#include <fmt/format.h>

#include "dbc/role_choices.h"

namespace eod::dbc {
namespace {

constexpr double kNotValid = std::numeric_limits<double>::quiet_NaN();

template <typename T>
T As(double value) {
  if constexpr (std::is_same_v<T, bool>) {
    return value != 0;
  } else if constexpr (std::is_enum_v<T>) {
    return static_cast<T>(static_cast<int>(value));
  } else {
    return static_cast<T>(value);
  }
}

/// Access to a plain field.
template <auto Member>
struct Plain;
template <typename State, typename T, T State::*Member>
struct Plain<Member> {
  static double Get(const State& state, int) { return static_cast<double>(state.*Member); }
  static void Set(State& state, int, double value) { state.*Member = As<T>(value); }
};

/// Access to an element of an array.
template <auto Member>
struct Element;
template <typename State, typename T, T State::*Member>
struct Element<Member> {
  static double Get(const State& state, int i) {
    return static_cast<double>((state.*Member)[static_cast<size_t>(i)]);
  }
  static void Set(State& state, int i, double value) {
    (state.*Member)[static_cast<size_t>(i)] = As<typename T::value_type>(value);
  }
};

/// Access to a bit of a set.
template <auto Member>
struct Bit;
template <typename State, uint32_t State::*Member>
struct Bit<Member> {
  static double Get(const State& state, int i) { return (state.*Member >> i & 1u) != 0 ? 1 : 0; }
  static void Set(State& state, int i, double value) {
    state.*Member = (state.*Member & ~(1u << i)) | (value != 0 ? 1u << i : 0u);
  }
};

struct AxisAccess {
  static double Get(const PanelState& panel, int i) {
    const Axis& axis = panel.axis[static_cast<size_t>(i)];
    return axis.valid ? axis.value : kNotValid;
  }
  static void Set(PanelState& panel, int i, double value) {
    const bool is_valid = !std::isnan(value);
    panel.axis[static_cast<size_t>(i)] = {is_valid ? value : 0, is_valid};
  }
};

/// Builds a list of roles, section by section.
template <typename State>
class Roles {
 public:
  Roles& Section(std::string_view section, std::string_view prefix) {
    section_ = section;
    prefix_ = prefix;
    return *this;
  }
  template <typename Access>
  Role<State>& Add(RoleKind kind, std::string_view key, int index = 0) {
    Role<State> role;
    role.section = section_;
    role.name = std::string(prefix_).append(key);
    role.key = key;
    role.kind = kind;
    role.index = index;
    role.get = &Access::Get;
    role.set = &Access::Set;
    list_.push_back(std::move(role));
    return list_.back();
  }
  template <auto Member>
  Role<State>& Flag(std::string key) {
    return AddChoice<Plain<Member>>(RoleKind::kFlag, std::move(key), choices::kFlag);
  }
  template <auto Member>
  Role<State>& Named(std::string key, const Choice& choice) {
    return AddChoice<Plain<Member>>(RoleKind::kChoice, std::move(key), choice);
  }
  template <auto Member>
  Role<State>& Count(std::string key) {
    return Add<Plain<Member>>(RoleKind::kCount, std::move(key));
  }
  template <auto Member>
  Role<State>& Quantity(std::string key, Dimension dimension) {
    Role<State>& role = Add<Plain<Member>>(RoleKind::kQuantity, std::move(key));
    role.dimension = dimension;
    return role;
  }
  template <typename Access>
  Role<State>& AddChoice(RoleKind kind, std::string key, const Choice& choice, int index = 0) {
    Role<State>& role = Add<Access>(kind, std::move(key), index);
    role.choice = &choice;
    role.safe = choice.fallback;
    return role;
  }
  std::vector<Role<State>> Take() { return std::move(list_); }

 private:
  std::string_view section_;
  std::string_view prefix_;
  std::vector<Role<State>> list_;
};

void AddSafetyRoles(Roles<PanelState>& roles) {
  using S = PanelState;
  roles.Named<&S::key>("key_switch", choices::kKeySwitch).essential = true;
  roles.Flag<&S::estop_a>("estop_a").essential = true;
  Role<S>& estop_b = roles.Flag<&S::estop_b>("estop_b");
  estop_b.essential = true;
  estop_b.safe = 1;  // pressed
  roles.Named<&S::deadman>("deadman", choices::kDeadman).essential = true;
  roles.Named<&S::reset>("reset", choices::kButton).essential = true;
  roles.Named<&S::start>("start", choices::kButton).essential = true;
  roles.Named<&S::mode>("control_mode", choices::kControlMode);
  roles.Named<&S::speed_range>("speed_range", choices::kSpeedRange);
  roles.Quantity<&S::speed_limit>("speed_limit", Dimension::kShare);
  roles.Count<&S::box_fault>("box_fault");
  roles.Quantity<&S::supply_v>("supply", Dimension::kVoltage);
  roles.Count<&S::variant>("variant");
  roles.Count<&S::protocol_major>("protocol_major");
}

void AddPanelRoles(Roles<PanelState>& roles) {
  using S = PanelState;
  Role<S>& channel_fault = roles.Flag<&S::button_channel_fault>("button_channel_fault");
  channel_fault.safe = 1;
  roles.Named<&S::joint_select>("joint_select", choices::kJoint);
  roles.Named<&S::preset>("preset", choices::kPreset);
  roles.Quantity<&S::joint_rate>("joint_rate", Dimension::kShare);
  roles.Named<&S::camera>("camera", choices::kCamera);
  roles.Named<&S::camera_zoom>("camera_zoom", choices::kZoom);
  roles.Named<&S::camera_focus>("camera_focus", choices::kFocus);
  roles.Named<&S::light>("light", choices::kLight);
  roles.Flag<&S::infrared>("infrared");
  roles.Flag<&S::push_to_talk>("push_to_talk");
  roles.Flag<&S::listen>("listen");
  roles.Flag<&S::lamp_test>("lamp_test");
  roles.Flag<&S::horn>("horn");
  roles.Flag<&S::buzzer_acknowledge>("buzzer_acknowledge");
  roles.Flag<&S::alarm_reset>("alarm_reset");
  roles.Named<&S::menu_module>("menu_module", choices::kModule);
  roles.Named<&S::menu_command>("menu_command", choices::kMenuCommand);
  roles.Count<&S::menu_exercise>("menu_exercise");
  roles.Quantity<&S::brightness>("brightness", Dimension::kShare);
  roles.Named<&S::arm_key>("arm_key", choices::kFireContact);
  roles.Named<&S::fire_left>("fire_left", choices::kFireContact);
  roles.Named<&S::fire_right>("fire_right", choices::kFireContact);
  roles.Named<&S::circuit>("circuit", choices::kCircuit);
  roles.Count<&S::nonce_echo>("nonce_echo");
  roles.Named<&S::nmt>("box_heartbeat", choices::kHeartbeat).essential = true;
  roles.Count<&S::error_code>("box_emergency_code");
  roles.Count<&S::error_register>("box_emergency_register");
}

std::vector<Role<PanelState>> MakePanelRoles() {
  Roles<PanelState> roles;
  roles.Section("controls", "");
  AddSafetyRoles(roles);
  AddPanelRoles(roles);
  roles.Section("motions", "motion.");
  for (int m = 0; m < kMotionCount; ++m) {
    roles
        .AddChoice<Element<&PanelState::motion>>(RoleKind::kFlag, fmt::format("M{:02}", m + 1),
                                                 choices::kFlag, m)
        .essential = true;
  }
  roles.Section("axes", "axis.");
  for (int a = 0; a < kAxisCount; ++a) {
    Role<PanelState>& axis = roles.AddChoice<AxisAccess>(
        RoleKind::kAxis, std::string(AxisNames()[static_cast<size_t>(a)]), choices::kAxis, a);
    axis.dimension = Dimension::kShare;
    axis.safe = kNotValid;
  }
  return roles.Take();
}

void AddDisplays(Roles<RobotFeedback>& roles) {
  using F = RobotFeedback;
  roles.Named<&F::state>("system_state", choices::kSystemState);
  roles.Named<&F::module>("module", choices::kModule);
  roles.Named<&F::mission_state>("mission_state", choices::kMissionState);
  roles.Flag<&F::is_simulator>("is_simulator").essential = true;
  roles.Named<&F::inhibit_reason>("inhibit_reason", choices::kInhibit);
  roles.Quantity<&F::link_quality>("link_quality", Dimension::kShare);
  roles.Quantity<&F::box_frame_age_s>("box_frame_age", Dimension::kTime);
  roles.Named<&F::buzzer>("buzzer", choices::kBuzzer);
  roles.Count<&F::hit_parts>("hit_parts");
  roles.Count<&F::alarm_code>("alarm_code");
  roles.Named<&F::grasp_state>("grasp_state", choices::kGrasp);
  roles.Quantity<&F::speed_mps>("speed", Dimension::kSpeed);
  roles.Quantity<&F::heading_deg>("heading", Dimension::kAngle);
  roles.Quantity<&F::pitch_deg>("pitch", Dimension::kAngle);
  roles.Quantity<&F::roll_deg>("roll", Dimension::kAngle);
  roles.Quantity<&F::battery_v>("battery_voltage", Dimension::kVoltage);
  roles.Quantity<&F::battery_a>("battery_current", Dimension::kCurrent);
  roles.Quantity<&F::battery_soc>("battery_charge", Dimension::kShare);
  roles.Quantity<&F::motor_temp_c>("motor_temperature", Dimension::kTemperature);
  roles.Quantity<&F::elapsed_s>("elapsed", Dimension::kTime);
  roles.Quantity<&F::score>("score", Dimension::kScore);
  roles.Count<&F::step>("step");
  roles.Count<&F::steps>("steps");
  roles.Named<&F::bomb_state>("bomb_state", choices::kBomb);
  roles.Named<&F::fail_reason>("fail_reason", choices::kFailure);
  roles.Count<&F::collisions>("collisions");
  roles.Named<&F::fire_state>("fire_state", choices::kFireState);
  roles.Count<&F::nonce>("nonce");
  roles.Count<&F::circuit_continuity>("circuit_continuity");
  roles.Named<&F::nmt>("robot_heartbeat", choices::kHeartbeat);
  roles.Count<&F::error_code>("emergency_code");
  roles.Count<&F::error_register>("emergency_register");
}

std::vector<Role<RobotFeedback>> MakeFeedbackRoles() {
  using F = RobotFeedback;
  constexpr int kGripperJoint = 6;
  Roles<F> roles;
  AddDisplays(roles.Section("displays", ""));
  roles.Section("inhibits", "inhibit.");
  for (int m = 0; m < kMotionCount; ++m) {
    roles.AddChoice<Bit<&F::inhibit_mask>>(RoleKind::kFlag, fmt::format("M{:02}", m + 1),
                                           choices::kFlag, m);
  }
  roles.Section("joints", "joint.");
  for (int j = 0; j < kJointCount; ++j) {
    roles.Add<Element<&F::joint>>(RoleKind::kQuantity, fmt::format("J{}", j + 1), j).dimension =
        j == kGripperJoint ? Dimension::kLength : Dimension::kAngle;
  }
  roles.Section("limits", "limit.");
  for (int j = 0; j < kJointCount; ++j) {
    roles.AddChoice<Bit<&F::limit_flags>>(RoleKind::kFlag, fmt::format("J{}", j + 1),
                                          choices::kFlag, j);
  }
  roles.Section("lamps", "lamp.");
  for (int l = 0; l < kLampCount; ++l) {
    roles.AddChoice<Element<&F::lamp>>(RoleKind::kChoice,
                                       std::string(LampChoice().values[static_cast<size_t>(l)]),
                                       choices::kLampPattern, l);
  }
  return roles.Take();
}

}  // namespace

const std::vector<Role<PanelState>>& PanelRoles() {
  static const std::vector<Role<PanelState>> roles = MakePanelRoles();
  return roles;
}

const std::vector<Role<RobotFeedback>>& FeedbackRoles() {
  static const std::vector<Role<RobotFeedback>> roles = MakeFeedbackRoles();
  return roles;
}

}  // namespace eod::dbc
