#include "lockstep/replay.h"

#include <algorithm>
#include <fstream>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "dbc/box_codec.h"
#include "platform/candump_log.h"
#include "sim/mission_report.h"
#include "sim/state_csv.h"

namespace eod::lockstep {
namespace {

namespace fs = std::filesystem;

/// What a strange bus carried towards the robot: everything but the robot's own frames.
std::vector<CanFrame> FramesToRobot(const ReplayConfig& config) {
  const dbc::Database database = dbc::LoadDatabase(config.rig.bridge.dbc_file);
  const dbc::ControlMap map = dbc::LoadControlMap(config.rig.bridge.map_file);
  const dbc::BoxCodec codec(database, map);
  std::vector<CanFrame> frames = ReadCandumpLog(config.can_log);
  std::erase_if(frames, [&codec](const CanFrame& frame) {
    return frame.error || codec.IsRobotId(frame.id, frame.extended);
  });
  if (frames.empty()) {
    throw std::runtime_error(
        fmt::format("{}: no frame from a control box in it", config.can_log.string()));
  }
  const auto earlier = [](const CanFrame& a, const CanFrame& b) { return a.stamp < b.stamp; };
  if (!std::ranges::is_sorted(frames, earlier)) {
    throw std::runtime_error(
        fmt::format("{}: time stamps go back: sort the log first", config.can_log.string()));
  }
  return frames;
}

/// One step before the first frame, on a whole multiple of the period: a log that lock-step made
/// then meets the simulator in the same phase again.
TimePoint StartOf(const std::vector<CanFrame>& frames, Duration period) {
  const Duration first = frames.front().stamp.time_since_epoch();
  return TimePoint{first - first % period - period};
}

/// A file that gets its name only when it is complete.
class PendingFile {
 public:
  explicit PendingFile(fs::path path) : path_(std::move(path)), pending_(path_) {
    pending_ += ".part";
  }
  ~PendingFile() {
    std::error_code ignored;
    fs::remove(pending_, ignored);
  }
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;

  const fs::path& pending() const { return pending_; }
  void Complete() { fs::rename(pending_, path_); }

 private:
  fs::path path_;
  fs::path pending_;
};

std::ofstream OpenForWriting(const fs::path& path) {
  std::ofstream out(path);
  if (!out) throw std::runtime_error(fmt::format("{}: cannot be written", path.string()));
  return out;
}

const char* ResultText(sim::MissionState state) {
  switch (state) {
    case sim::MissionState::kSuccess:
      return "success";
    case sim::MissionState::kFail:
      return "fail";
    case sim::MissionState::kAbort:
      return "abort";
    default:
      return "incomplete";
  }
}

/// Collects what result.json says about a run.
class RunResult {
 public:
  explicit RunResult(TimePoint start) : start_(start) {}

  void Take(const sim::StepResult& step) {
    for (const sim::AlarmChange& change : step.alarm_changes) {
      if (change.raised) {
        alarms_.push_back({{"t", ToSeconds(step.time - start_)},
                           {"code", static_cast<int>(change.code)},
                           {"parts", change.parts}});
      }
    }
  }

  nlohmann::ordered_json Json(const sim::Simulator& simulator, const sim::Scenario& scenario,
                              const CanBusCounters& counters) const {
    const sim::StepResult& last = simulator.last();
    return {{"scenario", scenario.name},
            {"repetition", scenario.repetition},
            {"module", simulator.module().name},
            {"result", ResultText(last.task.state)},
            {"score", last.task.score},
            {"mission_step", last.task.step},
            {"mission_steps", last.task.steps},
            {"sim_seconds", ToSeconds(last.time - start_)},
            {"steps", last.step},
            {"alarms", alarms_},
            {"can", {{"to_robot", counters.tx}, {"from_robot", counters.rx}}}};
  }

 private:
  TimePoint start_;
  nlohmann::ordered_json alarms_ = nlohmann::ordered_json::array();
};

void WriteJson(const fs::path& path, const nlohmann::ordered_json& json) {
  OpenForWriting(path) << json.dump(2) << '\n';
}

}  // namespace

void ReplayLog(const ReplayConfig& config, const sim::RobotModel& robot,
               const sim::WorldModel& world, const sim::Scenario& scenario) {
  const std::vector<CanFrame> frames = FramesToRobot(config);
  RigConfig rig_config = config.rig;
  rig_config.start = StartOf(frames, rig_config.sim.simulator.period);
  LockStepRig rig(rig_config, robot, world, scenario);
  const std::unique_ptr<CanBus> bus = rig.Connect();

  std::error_code failure;
  fs::create_directories(config.out, failure);
  if (failure) {
    throw std::runtime_error(
        fmt::format("{}: cannot be made: {}", config.out.string(), failure.message()));
  }
  PendingFile states_file(config.out / "states.csv");
  PendingFile log_file(config.out / "can.log");
  PendingFile result_file(config.out / "result.json");
  std::ofstream states = OpenForWriting(states_file.pending());
  std::optional<CandumpWriter> log(std::in_place, log_file.pending(), "lockstep");
  sim::StateCsv csv(states);
  RunResult result(rig_config.start);
  sim::MissionReport report(config.report);
  rig.SetStepSink([&](const sim::StepResult& step, const sim::AlarmTable& alarms) {
    report.Watch(rig.simulator());
    csv.Write(step, alarms);
    result.Take(step);
  });

  const TimePoint end = frames.back().stamp + config.tail;
  auto next = frames.begin();
  while (rig.now() < end) {
    while (next != frames.end() && next->stamp <= rig.now() + kTick) bus->Send(*next++);
    rig.Tick();
    while (const std::optional<CanFrame> sent = bus->Receive()) log->Write(*sent);
  }
  report.Finish(rig.simulator());
  WriteJson(result_file.pending(), result.Json(rig.simulator(), scenario, bus->counters()));
  states.close();
  log.reset();
  states_file.Complete();
  log_file.Complete();
  result_file.Complete();
}

}  // namespace eod::lockstep
