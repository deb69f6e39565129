// What the operator's page shows for a choice of camera.
#include "console/operator_page.h"

#include <array>
#include <string_view>

#include <gtest/gtest.h>

#include "console/console_config.h"
#include "sim/camera/camera_choice.h"

namespace eod::console {
namespace {

TEST(OperatorPage, ShowsThePicturesThatTheSimulatorSendsAtTheFullRate) {
  for (const int choice : {0, 1, 2, 3, 4}) {
    const Shown shown = ShownFor(choice);
    EXPECT_NE(shown.chosen, shown.beside);
    for (const std::string_view camera : {"drive", "mast", "gripper", "rear", "quad"}) {
      const bool is_shown = camera == shown.chosen || camera == shown.beside;
      EXPECT_EQ(sim::PictureInterval(choice, camera), is_shown ? 1 : 0) << choice << " " << camera;
    }
  }
}

TEST(OperatorPage, ShowsTheChosenCameraFirst) {
  EXPECT_EQ(ShownFor(0).chosen, "quad");
  EXPECT_EQ(ShownFor(1).chosen, "drive");
  EXPECT_EQ(ShownFor(2).chosen, "gripper");
  EXPECT_EQ(ShownFor(3).chosen, "mast");
  EXPECT_EQ(ShownFor(4).chosen, "rear");
}

TEST(OperatorPage, AsksForBothStreamsAndLinksEachCamera) {
  const std::string page = OperatorPage();
  for (const auto* stream :
       {"/step.txt", "/chosen.mjpeg", "/beside.mjpeg", "/drive.mjpeg", "/mast.mjpeg",
        "/gripper.mjpeg", "/rear.mjpeg", "/quad.mjpeg", "/beside.txt"}) {
    EXPECT_NE(page.find(stream), std::string::npos) << stream;
  }
}

TEST(OperatorPage, TellsTheStepCountedFromOne) {
  EXPECT_EQ(StepText(true, 1, 6, "Lift it"), "Step 2 of 6: Lift it");
  EXPECT_NE(StepText(false, 1, 6, "Lift it").find("No exercise runs"), std::string::npos);
}

TEST(Description, NamesTheAddressAndTheStationsChannels) {
  const std::string text = Describe({.channel_prefix = "B_", .port = 8123});
  EXPECT_NE(text.find("http://127.0.0.1:8123/"), std::string::npos);
  EXPECT_NE(text.find("B_EOD_CAMERA_GRIPPER"), std::string::npos);
}

}  // namespace
}  // namespace eod::console
