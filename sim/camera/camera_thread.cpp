#include "sim/camera/camera_thread.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstdlib>
#include <exception>
#include <future>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <utility>

#include <fmt/format.h>
#include <malloc.h>
#include <pthread.h>

#include "platform/priority.h"
#include "sim/camera/camera_choice.h"
#include "sim/camera/gl_context.h"
#include "sim/camera/jpeg_encoder.h"
#include "sim/camera/picture_maker.h"
#include "sim/camera/picture_schedule.h"

namespace eod::sim {
namespace {

void CheckConfig(const RobotModel& robot, const CameraConfig& config) {
  for (const std::string& name : config.cameras) {
    ViewsOf(robot, name, config.width, config.height);
  }
  const auto check = [](const char* what, double value, double low, double high) {
    if (value < low || value > high) {
      throw std::runtime_error(
          fmt::format("cameras: {} = {}, allowed {}..{}", what, value, low, high));
    }
  };
  check("width", config.width, 64, 1920);
  check("height", config.height, 48, 1080);
  check("rate_hz", config.rate_hz, 1, 60);
  check("jpeg_quality", config.jpeg_quality, 1, 100);
}

}  // namespace

class CameraThread::Worker {
 public:
  Worker(const RobotModel& robot, const WorldModel& world, CameraConfig config, PictureSink sink)
      : robot_(robot),
        world_(world),
        config_(std::move(config)),
        sink_(std::move(sink)),
        schedule_(config_.cameras.size(), config_.rate_hz) {
    std::promise<void> started;
    std::future<void> outcome = started.get_future();
    thread_ = std::thread([this, &started] { Run(started); });
    try {
      outcome.get();
    } catch (...) {
      thread_.join();
      throw;
    }
  }

  ~Worker() {
    {
      const std::lock_guard lock(mutex_);
      stopping_ = true;
    }
    wake_.notify_one();
    thread_.join();
  }

  void Show(const SceneSnapshot& snapshot) {
    {
      const std::lock_guard lock(mutex_);
      newest_ = snapshot;
      is_new_ = true;
    }
    wake_.notify_one();
  }

  uint64_t pictures() const { return pictures_.load(std::memory_order_relaxed); }

 private:
  void Run(std::promise<void>& started) {
    try {
      pthread_setname_np(pthread_self(), "eod-camera");
      RunAfterOthers();
      // Everything of OpenGL is made, used and destroyed on this thread.
      const std::unique_ptr<GlContext> context = MakeGlContext(config_.backend);
      PictureMaker maker(context->gl(), robot_, world_, config_.width, config_.height,
                         config_.draw_data);
      JpegEncoder encoder(config_.width, config_.height, config_.jpeg_quality);
      malloc_trim(0);  // what painting and loading took and gave back, tens of megabytes
      started.set_value();
      Loop(maker, encoder);
    } catch (...) {
      started.set_exception(std::current_exception());
    }
  }

  void Loop(PictureMaker& maker, JpegEncoder& encoder) {
    SceneSnapshot snapshot;
    std::vector<int> intervals(config_.cameras.size());
    while (TakeNewest(snapshot)) {
      for (size_t i = 0; i < intervals.size(); ++i) {
        intervals[i] = PictureInterval(snapshot.camera_select, config_.cameras[i]);
      }
      schedule_.Choose(intervals, snapshot.time);
      maker.Show(snapshot);
      encoder.set_quality(PictureLink::JpegQuality(snapshot.link_quality, config_.jpeg_quality));
      // All pictures that are due show the same moment.
      while (const std::optional<size_t> due = schedule_.Due(snapshot.time)) {
        schedule_.Drawn(*due, snapshot.time);
        HandOut(config_.cameras[*due], snapshot.time, maker.Make(config_.cameras[*due]), encoder);
        if (IsStopping()) return;
      }
    }
  }

  void HandOut(const std::string& name, TimePoint time, const std::vector<uint8_t>& pixels,
               JpegEncoder& encoder) {
    const std::span<const uint8_t> jpeg = encoder.Encode(pixels);
    if (jpeg.empty()) return;
    pictures_.fetch_add(1, std::memory_order_relaxed);
    sink_({name, time, config_.width, config_.height, jpeg});
  }

  /// Waits for a snapshot; false when the thread is to end.
  bool TakeNewest(SceneSnapshot& snapshot) {
    std::unique_lock lock(mutex_);
    wake_.wait(lock, [this] { return is_new_ || stopping_; });
    if (stopping_) return false;
    std::swap(snapshot, newest_);
    is_new_ = false;
    return true;
  }

  bool IsStopping() {
    const std::lock_guard lock(mutex_);
    return stopping_;
  }

  const RobotModel& robot_;
  const WorldModel& world_;
  const CameraConfig config_;
  const PictureSink sink_;
  PictureSchedule schedule_;
  std::atomic<uint64_t> pictures_{0};

  std::mutex mutex_;
  std::condition_variable wake_;
  SceneSnapshot newest_;  // guarded by mutex_, as are the two below
  bool is_new_ = false;
  bool stopping_ = false;
  std::thread thread_;
};

CameraThread::CameraThread(const RobotModel& robot, const WorldModel& world, CameraConfig config,
                           PictureSink sink) {
  CheckConfig(robot, config);
  // Two threads for the pixels: with one, two cameras want all of a core for 25 pictures a second.
  // The step takes its share by priority. Mesa reads this once a process.
  setenv("LP_NUM_THREADS", "2", 0);
  worker_ = std::make_unique<Worker>(robot, world, std::move(config), std::move(sink));
}

CameraThread::~CameraThread() = default;

void CameraThread::Show(const SceneSnapshot& snapshot) { worker_->Show(snapshot); }

uint64_t CameraThread::pictures() const { return worker_->pictures(); }

}  // namespace eod::sim
