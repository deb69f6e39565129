#include "sim/state_csv.h"

#include <sstream>

#include <gtest/gtest.h>

#include "tests/unit/behaviour/operator.h"

namespace eod::sim {
namespace {

std::string Record(int steps) {
  std::ostringstream text;
  StateCsv dut(text);
  Operator op;
  op.Press({kDriveForward, kTurnLeft, kBigArmDown}, 1.0 / 3);
  for (int i = 0; i < steps; ++i) {
    op.Step();
    dut.Write(op.dut.last(), op.dut.alarms());
  }
  return text.str();
}

TEST(StateCsv, EqualRunsGiveEqualBytes) {
  const std::string text = Record(200);
  EXPECT_EQ(text, Record(200));
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 201);
}

TEST(StateCsv, EveryLineHasEveryColumn) {
  std::istringstream lines(Record(3));
  std::string line;
  while (std::getline(lines, line)) {
    EXPECT_EQ(std::count(line.begin(), line.end(), ','), 36) << line;
  }
}

TEST(StateCsv, NumbersReadBackAsTheSameBits) {
  std::ostringstream text;
  StateCsv dut(text);
  StepResult result;
  result.step = 7;
  result.state.position = {0.1 + 0.2, 1e-300, -1.0 / 3};
  dut.Write(result, AlarmTable());
  std::istringstream line(text.str().substr(text.str().find('\n') + 1));
  std::string cell;
  std::vector<std::string> cells;
  while (std::getline(line, cell, ',')) cells.push_back(cell);
  EXPECT_EQ(cells[0], "7");
  for (int i = 0; i < 3; ++i) EXPECT_EQ(std::stod(cells[3 + i]), result.state.position[i]);
}

TEST(StateCsv, AlarmsStandGravestFirst) {
  std::ostringstream text;
  StateCsv dut(text);
  AlarmTable alarms;
  std::vector<AlarmChange> changes;
  alarms.Set(AlarmCode::kCollision, true, 3, changes);
  alarms.Set(AlarmCode::kPushAfterAlarm, true, 3, changes);
  dut.Write({}, alarms);
  EXPECT_NE(text.str().find(",0x11+0x10,"), std::string::npos) << text.str();
}

}  // namespace
}  // namespace eod::sim
