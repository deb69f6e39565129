#include "sim/camera/camera_thread.h"

#include <condition_variable>
#include <map>
#include <mutex>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/camera/fixture_scene.h"

namespace eod::sim {
namespace {

using std::chrono::milliseconds;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;
using ::testing::UnorderedElementsAre;

struct TakenPicture {
  std::string camera;
  TimePoint time;
  std::vector<uint8_t> jpeg;
};

/// Collects pictures, and can hold the camera's thread inside the sink.
class Album {
 public:
  CameraThread::PictureSink sink() {
    return [this](const Picture& picture) {
      std::unique_lock lock(mutex_);
      pictures_.push_back(
          {std::string(picture.camera), picture.time, {picture.jpeg.begin(), picture.jpeg.end()}});
      changed_.notify_all();
      changed_.wait(lock, [this] { return !is_closed_; });
    };
  }

  void Close() { SetClosed(true); }
  void Open() { SetClosed(false); }

  std::vector<TakenPicture> WaitFor(size_t count) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return pictures_.size() >= count; });
    return pictures_;
  }

 private:
  void SetClosed(bool is_closed) {
    const std::lock_guard lock(mutex_);
    is_closed_ = is_closed;
    changed_.notify_all();
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<TakenPicture> pictures_;
  bool is_closed_ = false;
};

SceneSnapshot Snapshot(milliseconds time) {
  SceneSnapshot snapshot;
  snapshot.time = TimePoint{time};
  snapshot.state = StandingAt(0, 0);
  return snapshot;
}

class CameraThreadTest : public ::testing::Test {
 protected:
  static CameraConfig Small(std::vector<std::string> cameras) {
    return {.cameras = std::move(cameras), .width = 160, .height = 120, .rate_hz = 50};
  }

  const RobotModel robot_ = FixtureRobot();
  const WorldModel world_ = FixtureWorld();
  Album album_;
};

TEST_F(CameraThreadTest, HandsOutAJpegOfEachCameraWithTheTimeOfTheStep) {
  CameraThread dut(robot_, world_, Small({"drive", "mast"}), album_.sink());
  dut.Show(Snapshot(milliseconds(40)));
  const auto pictures = album_.WaitFor(2);
  EXPECT_EQ(pictures[0].camera, "drive");
  EXPECT_EQ(pictures[1].camera, "mast");
  for (const TakenPicture& picture : pictures) {
    EXPECT_EQ(picture.time, TimePoint{milliseconds(40)});
    // Start and end of image markers (ITU-T T.81, table B.1).
    ASSERT_GT(picture.jpeg.size(), 500U);
    EXPECT_THAT(std::vector(picture.jpeg.begin(), picture.jpeg.begin() + 2),
                ElementsAre(0xFF, 0xD8));
    EXPECT_THAT(std::vector(picture.jpeg.end() - 2, picture.jpeg.end()), ElementsAre(0xFF, 0xD9));
  }
  EXPECT_EQ(dut.pictures(), 2U);
}

TEST_F(CameraThreadTest, GivesTheSameJpegForTheSameSnapshots) {
  const auto run = [&] {
    Album album;
    CameraThread dut(robot_, world_, Small({"drive"}), album.sink());
    dut.Show(Snapshot(milliseconds(0)));
    return album.WaitFor(1)[0].jpeg;
  };
  EXPECT_EQ(run(), run());
}

TEST_F(CameraThreadTest, ForgetsAllButTheNewestSnapshotWhileItDraws) {
  CameraThread dut(robot_, world_, Small({"drive"}), album_.sink());
  album_.Close();
  dut.Show(Snapshot(milliseconds(0)));
  album_.WaitFor(1);
  // The thread is held in its sink; of these only the last is to be drawn.
  for (int i = 1; i <= 10; ++i) dut.Show(Snapshot(milliseconds(100 * i)));
  album_.Open();
  const auto pictures = album_.WaitFor(2);
  EXPECT_EQ(pictures[1].time, TimePoint{milliseconds(1000)});
  EXPECT_EQ(dut.pictures(), 2U);
}

TEST_F(CameraThreadTest, RendersTheCamerasThatTheOperatorChose) {
  RobotModel robot = robot_;
  for (const char* name : {"gripper", "rear"}) {
    robot.cameras.push_back(robot.cameras[0]);
    robot.cameras.back().name = name;
  }
  CameraThread dut(robot, world_, Small({"drive", "gripper", "mast", "rear"}), album_.sink());
  const auto cameras_for = [&](int choice, milliseconds time, size_t before) {
    SceneSnapshot snapshot = Snapshot(time);
    snapshot.camera_select = choice;
    dut.Show(snapshot);
    std::vector<std::string> names;
    for (const TakenPicture& picture : album_.WaitFor(before + 2)) names.push_back(picture.camera);
    return std::vector<std::string>(names.begin() + static_cast<std::ptrdiff_t>(before),
                                    names.end());
  };
  EXPECT_THAT(cameras_for(1, milliseconds(0), 0), UnorderedElementsAre("drive", "mast"));
  EXPECT_THAT(cameras_for(2, milliseconds(100), 2), UnorderedElementsAre("gripper", "mast"));
  EXPECT_THAT(cameras_for(4, milliseconds(200), 4), UnorderedElementsAre("drive", "rear"));
}

TEST_F(CameraThreadTest, EndsWithASnapshotStillWaiting) {
  auto dut = std::make_unique<CameraThread>(robot_, world_, Small({"drive"}), album_.sink());
  album_.Close();
  dut->Show(Snapshot(milliseconds(0)));
  album_.WaitFor(1);
  dut->Show(Snapshot(milliseconds(100)));
  album_.Open();
  dut.reset();
  SUCCEED() << "the thread was joined";
}

TEST_F(CameraThreadTest, LowersTheQualityOfAPictureThatDoesNotFitADatagram) {
  CameraConfig config{.cameras = {"drive"}, .width = 1280, .height = 960, .jpeg_quality = 100};
  CameraThread dut(robot_, world_, config, album_.sink());
  dut.Show(Snapshot(milliseconds(0)));
  const auto pictures = album_.WaitFor(1);
  EXPECT_LE(pictures[0].jpeg.size(), 65000U);
  EXPECT_GT(pictures[0].jpeg.size(), 10000U);
}

TEST_F(CameraThreadTest, UnknownCameraIsAnErrorOfOneLine) {
  EXPECT_THAT(
      [&] {
        CameraThread(robot_, world_, Small({"drive", "sideways"}), album_.sink());
      },
      ThrowsMessage<std::runtime_error>(
          "fixture_robot.sdf: no camera \"sideways\"; there are: drive, mast"));
}

TEST_F(CameraThreadTest, RefusesRatesAndSizesOutOfRange) {
  CameraConfig fast = Small({"drive"});
  fast.rate_hz = 200;
  EXPECT_THAT([&] { CameraThread(robot_, world_, fast, album_.sink()); },
              ThrowsMessage<std::runtime_error>("cameras: rate_hz = 200, allowed 1..60"));
  CameraConfig tiny = Small({"drive"});
  tiny.width = 0;
  EXPECT_THAT([&] { CameraThread(robot_, world_, tiny, album_.sink()); },
              ThrowsMessage<std::runtime_error>(HasSubstr("width = 0")));
}

TEST_F(CameraThreadTest, ErrorsOfTheCamerasOwnThreadReachTheCaller) {
  WorldModel world = FixtureWorld();
  RobotModel robot = FixtureRobot();
  robot.visuals[0].visual.material.texture = "marble";
  EXPECT_THAT([&] { CameraThread(robot, world, Small({"drive"}), album_.sink()); },
              ThrowsMessage<std::runtime_error>(HasSubstr("\"marble\"")));
}

}  // namespace
}  // namespace eod::sim
