#include "sim/state_csv.h"

#include <array>
#include <charconv>
#include <type_traits>

namespace eod::sim {
namespace {

void AppendDigits(std::string& line, int64_t value, int base) {
  std::array<char, 72> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value, base).ptr;
  line.append(digits.data(), end);
}

void Append(std::string& line, double value) {
  std::array<char, 32> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  line.append(digits.data(), end).push_back(',');
}

template <typename Integer>
requires std::is_integral_v<Integer>
void Append(std::string& line, Integer value) {
  AppendDigits(line, static_cast<int64_t>(value), 10);
  line.push_back(',');
}

void AppendSet(std::string& line, uint32_t set) {
  line += "0x";
  AppendDigits(line, set, 16);
  line.push_back(',');
}

void AppendAlarms(std::string& line, const AlarmTable& alarms) {
  const char* separator = "0x";
  for (const ActiveAlarm& alarm : alarms.active()) {
    line += separator;
    AppendDigits(line, static_cast<int>(alarm.code), 16);
    separator = "+0x";
  }
  line.push_back(',');
}

}  // namespace

StateCsv::StateCsv(std::ostream& out) : out_(out) {
  out_ << "step,time_us,module,x_m,y_m,z_m,heading_rad,pitch_rad,roll_rad,j1,j2,j3,j4,j5,j6,j7,j8,"
          "j9,"
          "left_m,right_m,speed_mps,turn_rps,inhibited,contact_parts,reason,alarms,mission,"
          "mission_step,score,grasp,bomb,charge_x_m,charge_y_m,charge_z_m,charge_tilt_rad,fire,"
          "detonation\n";
}

void StateCsv::Write(const StepResult& result, const AlarmTable& alarms) {
  const RobotState& state = result.state;
  line_.clear();
  Append(line_, result.step);
  Append(line_, ToUtime(result.time));
  Append(line_, result.module);
  for (const double metre : state.position) Append(line_, metre);
  for (const double angle : {state.attitude.heading, state.attitude.pitch, state.attitude.roll}) {
    Append(line_, angle);
  }
  for (const double coordinate : state.joint) Append(line_, coordinate);
  for (const double number :
       {state.left_opening, state.right_opening, result.speed, result.turn_rate}) {
    Append(line_, number);
  }
  AppendSet(line_, result.inhibited);
  AppendSet(line_, result.contact_parts);
  Append(line_, result.inhibit_reason);
  AppendAlarms(line_, alarms);
  Append(line_, static_cast<int>(result.task.state));
  Append(line_, result.task.step);
  Append(line_, result.task.score);
  const DisposalStatus& disposal = result.disposal;
  Append(line_, static_cast<int>(disposal.grasp));
  Append(line_, static_cast<int>(disposal.bomb));
  for (const double metre : result.charge) Append(line_, metre);
  Append(line_, disposal.bomb_tilt);
  Append(line_, static_cast<int>(disposal.fire));
  Append(line_, static_cast<int>(disposal.detonation));
  line_.back() = '\n';
  out_ << line_;
}

}  // namespace eod::sim
