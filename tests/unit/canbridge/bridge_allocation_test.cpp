#include <vector>

#include <gtest/gtest.h>

#include "canbridge/bridge.h"
#include "dbc/box_codec.h"
#include "tests/unit/counting_new.h"

namespace eod::bridge {
namespace {

using std::chrono::milliseconds;

/// What the box sends in 4 s: drives, stops, alternates buttons, goes silent for 700 ms in between.
std::vector<std::vector<CanFrame>> RecordBox(dbc::BoxCodec& codec) {
  std::vector<std::vector<CanFrame>> frames(4000);
  dbc::PanelState panel;
  panel.key = dbc::KeySwitch::kOperate;
  panel.nmt = dbc::NmtState::kOperational;
  for (std::size_t ms = 0; ms < frames.size(); ++ms) {
    if (ms >= 2000 && ms < 2700) continue;
    panel.deadman = ms % 1000 > 300 ? dbc::Deadman::kEnabled : dbc::Deadman::kReleased;
    panel.motion[0] = ms % 400 > 200;
    if (ms % 200 == 0) frames[ms].push_back(*codec.Encode(dbc::BoxMessage::kHeartbeat, panel));
    if (ms % 50 == 0) frames[ms].push_back(*codec.Encode(dbc::BoxMessage::kPanel, panel));
    if (ms % 20 != 0) continue;
    for (const auto role : {dbc::BoxMessage::kSafety, dbc::BoxMessage::kMotion,
                            dbc::BoxMessage::kAxes, dbc::BoxMessage::kFire}) {
      frames[ms].push_back(*codec.Encode(role, panel));
    }
  }
  return frames;
}

TEST(BridgeAllocation, NoneInFramesTicksStatesAndAlarms) {
  const dbc::Database database = dbc::LoadDatabase(EOD_DATA_DIR "/dbc/control_box.dbc");
  const dbc::ControlMap map = dbc::LoadControlMap(EOD_DATA_DIR "/dbc/control_box.map.toml");
  dbc::BoxCodec box(database, map);
  const auto frames = RecordBox(box);
  Bridge dut({}, database, map);
  AlarmReport collision;
  collision.active[0] = {0x10, 0b11};
  collision.count = 1;

  long after_warm_up = 0;
  std::size_t sent = 0;
  for (std::size_t ms = 0; ms < frames.size(); ++ms) {
    if (ms == 1000) after_warm_up = AllocationCount();
    const TimePoint now{milliseconds(ms)};
    for (const CanFrame& frame : frames[ms]) dut.OnFrame(now, frame);
    RobotReport robot;
    robot.fire_nonce = static_cast<int>(ms / 700 % 256);
    if (ms % 4 == 0) dut.OnRobotState(now, robot);
    if (ms % 100 == 0) dut.OnMission(now, {});
    if (ms % 50 == 0) dut.OnAlarms(now, ms % 100 == 0 ? collision : AlarmReport{});
    sent += dut.Tick(now, {}).frames.size();
  }
  EXPECT_GT(after_warm_up, 0);  // the counter is in place
  EXPECT_EQ(AllocationCount(), after_warm_up);
  EXPECT_GT(sent, 500U) << "it did work";
}

}  // namespace
}  // namespace eod::bridge
