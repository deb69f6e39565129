#include "recorder/summary.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace eod::recorder {
namespace {

using testing::HasSubstr;

Summary ExampleRun() {
  Summary summary;
  summary.bus = "udp:239.74.163.2:43113";
  summary.module = "flat";
  summary.result = "success";
  summary.sim_seconds = 62.5;
  summary.alarms = {{12.3456789, 0x10, 0b11}};
  summary.can.rx = 7;
  summary.can.lost = 2;
  summary.camera.fps = 29.97;
  summary.latency_ms.button_to_pose = {3.0, 4.25, 12};
  summary.step.period_ms = 4;
  return summary;
}

TEST(Summary, HasExactlyTheKeysOfTheContractInTheirOrder) {
  Summary summary = ExampleRun();
  summary.alarms.clear();
  EXPECT_EQ(ToJson(summary), R"({
  "bus": "udp:239.74.163.2:43113",
  "module": "flat",
  "result": "success",
  "sim_seconds": 62.5,
  "alarms": [],
  "can": {
    "rx": 7,
    "tx": 0,
    "lost": 2,
    "crc_errors": 0,
    "bus_load_percent": 0.0
  },
  "camera": {
    "frames": 0,
    "fps": 29.97,
    "width": 0,
    "height": 0
  },
  "latency_ms": {
    "button_to_pose": {
      "p50": 3.0,
      "p99": 4.25,
      "n": 12
    },
    "contact_to_lamp_frame": {
      "p50": null,
      "p99": null,
      "n": 0
    }
  },
  "step": {
    "period_ms": 4.0,
    "overruns": 0
  }
}
)");
}

TEST(Summary, ListsAlarmsWithTimeCodeAndParts) {
  const auto json = nlohmann::json::parse(ToJson(ExampleRun()));
  const auto expected = nlohmann::json::parse(R"([{"t": 12.346, "code": 16, "parts": 3}])");
  EXPECT_EQ(json["alarms"], expected);
}

TEST(Summary, SurvivesTextThatIsNotUtf8) {
  Summary summary = ExampleRun();
  summary.bus = "udp:\xff";
  EXPECT_NO_THROW(nlohmann::json::parse(ToJson(summary)));
}

TEST(Summary, TellsPeopleTheSame) {
  const std::string text = ToText(ExampleRun());
  EXPECT_THAT(text, HasSubstr("success, module flat, 62.5 s simulated"));
  EXPECT_THAT(text, HasSubstr("12.35 s  collision: front wheels"));
  EXPECT_THAT(text, HasSubstr("p50 3.00 ms, p99 4.25 ms, n 12"));
  EXPECT_THAT(text, HasSubstr("contact to lamp  no sample"));
}

TEST(Names, OfModulesAlarmsAndParts) {
  EXPECT_EQ(ModuleName(1), "flat");
  EXPECT_EQ(ModuleName(5), "indoor");
  EXPECT_EQ(ModuleName(6), "none");
  EXPECT_EQ(ModuleName(-1), "none");
  EXPECT_EQ(AlarmName(0x80), "e-stop");
  EXPECT_EQ(AlarmName(0x99), "alarm 0x99");
  EXPECT_EQ(PartNames(0), "");
  EXPECT_EQ(PartNames(0b10), "front right wheel");
  EXPECT_EQ(PartNames(0b1011), "front wheels, rear right wheel");
  EXPECT_EQ(PartNames(1U << 6 | 1U << 11), "crossbeam, held bomb");
}

}  // namespace
}  // namespace eod::recorder
