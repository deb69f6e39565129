#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/world/world_model.h"
#include "tests/unit/sim/edited_file.h"

namespace eod::sim {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class WorldErrors : public ::testing::Test {
 protected:
  EditedFile world_{EOD_DATA_DIR "/sim/worlds/training_ground.sdf"};

  std::string Load() {
    try {
      LoadWorld(world_.file());
    } catch (const std::runtime_error& error) {
      EXPECT_THAT(error.what(), Not(HasSubstr("\n"))) << "one line";
      return error.what();
    }
    return "loaded";
  }
};

TEST_F(WorldErrors, MissingFileIsNamed) {
  EXPECT_THAT([] { LoadWorld("/nowhere/world.sdf"); },
              testing::ThrowsMessage<std::runtime_error>("/nowhere/world.sdf: cannot be read"));
}

TEST_F(WorldErrors, FileThatIsNoSdfIsRefused) {
  EXPECT_THAT([] { LoadWorld(EOD_DATA_DIR "/LICENSE"); },
              testing::ThrowsMessage<std::runtime_error>(StartsWith(EOD_DATA_DIR "/LICENSE:")));
}

TEST_F(WorldErrors, BrokenXmlNamesTheLine) {
  world_.Replace("</world>", "");
  EXPECT_THAT(Load(), AllOf(StartsWith(world_.PlaceOf("<world")), HasSubstr("broken XML")));
}

TEST_F(WorldErrors, WhatTheFormatKnowsIsAcceptedHoweverSeldomAndElseRefused) {
  const std::string pbr = "<material>\n<pbr><metal><roughness>0.5</roughness></metal></pbr>";
  world_.Replace("<material>", pbr);
  EXPECT_EQ(Load(), "loaded");
  const std::string place = world_.Replace("<roughness>0.5</roughness>", "<ruffness>0</ruffness>");
  EXPECT_THAT(Load(), AllOf(StartsWith(place), HasSubstr("ruffness")));
}

TEST_F(WorldErrors, ModuleWithoutItsFrameIsRefused) {
  const std::string place = world_.Replace("frame=\"flat\"", "frame=\"flet\"");
  EXPECT_THAT(Load(), AllOf(StartsWith(place), HasSubstr("frame = \"flet\"")));
}

TEST_F(WorldErrors, ModuleNumberOutOfRangeIsRefused) {
  const std::string place = world_.Replace("id=\"1\"", "id=\"6\"");
  EXPECT_THAT(Load(), AllOf(StartsWith(place), HasSubstr("id = 6"), HasSubstr("1..5")));
}

TEST_F(WorldErrors, SecondModelOfANameIsRefusedHoweverFarApart) {
  const std::string first = world_.PlaceOf("<model name=\"ground\"");
  const std::string place = world_.Replace("<model name=\"forest\"", "<model name=\"ground\"");
  const std::string line = first.substr(world_.file().string().size() + 1);
  EXPECT_EQ(Load(),
            place + "second model ground; the first is in line " + line.substr(0, line.find(':')));
}

TEST_F(WorldErrors, SecondModuleOfANumberIsRefused) {
  const std::string place = world_.Replace(
      "<eod:module",
      "<eod:module id=\"1\" name=\"f\" frame=\"flat\" size_x_m=\"9\" size_y_m=\"9\"/>"
      "<eod:module");
  EXPECT_THAT(Load(), AllOf(StartsWith(place), HasSubstr("second module 1")));
}

TEST_F(WorldErrors, ModelOutsideEveryModuleIsRefused) {
  world_.Replace("<pose relative_to=\"flat\">0 4 0", "<pose>0 4 0");
  EXPECT_THAT(Load(), AllOf(StartsWith(world_.PlaceOf("<model name=\"wall\"")),
                            HasSubstr("model wall: its <pose> needs relative_to")));
}

TEST_F(WorldErrors, UnknownFrameNamesTheLine) {
  const std::string place =
      world_.Replace("<pose relative_to=\"flat\">0 4 0", "<pose relative_to=\"flet\">0 4 0");
  EXPECT_THAT(Load(), AllOf(StartsWith(place), HasSubstr("flet")));
}

TEST_F(WorldErrors, UnknownProxyIsRefused) {
  const std::string place =
      world_.Replace("<collision name=\"c2\">", "<collision name=\"c2\"><eod:proxy kind=\"bum\"/>");
  EXPECT_THAT(Load(), AllOf(StartsWith(place), HasSubstr("kind = \"bum\""), HasSubstr("clamp")));
}

TEST_F(WorldErrors, UnknownElementOfOursIsRefused) {
  const std::string place = world_.Replace("<eod:surface", "<eod:surfaze");
  EXPECT_THAT(Load(),
              AllOf(StartsWith(place), HasSubstr("<eod:surfaze>"), HasSubstr("eod:surface")));
}

TEST_F(WorldErrors, BadNumberNamesTheLine) {
  const std::string place = world_.Replace("<size>4 0.25 1.2</size>", "<size>4 thin 1.2</size>");
  EXPECT_THAT(Load(), AllOf(StartsWith(place), HasSubstr("4 thin 1.2")));
}

TEST_F(WorldErrors, ProxyKindsReachTheTriangles) {
  world_.Replace("<collision name=\"c2\">", "<collision name=\"c2\"><eod:proxy kind=\"clamp\"/>");
  const WorldModel world = LoadWorld(world_.file());
  EXPECT_EQ(world.Module(1).triangles[0].class_mask, kModuleFlat | kClampProxy);
  EXPECT_EQ(world.Module(1).triangles.back().class_mask, kModuleFlat | kClampProxy | kBumpProxy);
}

TEST_F(WorldErrors, ModelThatNobodyCalledMovableIsRefused) {
  world_.Replace("<static>true</static>", "<static>false</static>");
  EXPECT_THAT(Load(), AllOf(StartsWith(world_.PlaceOf("<model")), HasSubstr("needs <static>true"),
                            HasSubstr("<eod:movable friction")));
}

}  // namespace
}  // namespace eod::sim
