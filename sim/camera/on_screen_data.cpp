#include "sim/camera/on_screen_data.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace eod::sim {
namespace {

constexpr int kShortBelow = 480;  // [px] of width
constexpr std::array<uint8_t, 3> kMarkColour{224, 44, 36};
constexpr std::array<uint8_t, 3> kMarkRim{10, 10, 10};
constexpr std::string_view kMark = "SIM";
constexpr std::string_view kNoSignal = "NO SIGNAL";

double ToDegrees(double radians) { return radians * 180 / std::numbers::pi; }

/// Without "-0.0", which says that something is about to tilt.
double Tidy(double value, double step) {
  const double rounded = std::round(value / step) * step;
  return rounded == 0 ? 0.0 : rounded;
}

std::string Clock(TimePoint time) {
  using std::chrono::days;
  using std::chrono::milliseconds;
  const auto since_midnight = time - std::chrono::floor<days>(time);
  const auto tenths = std::chrono::duration_cast<milliseconds>(since_midnight).count() / 100;
  return fmt::format("{:02}:{:02}:{:02}.{}", tenths / 36000, tenths / 600 % 60, tenths / 10 % 60,
                     tenths % 10);
}

/// Positive is left, as the joint counts; operators think in left and right.
std::string PanText(double degrees) {
  const double rounded = Tidy(degrees, 1);
  return fmt::format("{:03.0f}\xB0{}", std::abs(rounded),
                     rounded > 0   ? 'L'
                     : rounded < 0 ? 'R'
                                   : ' ');
}

std::string HeadText(const RobotModel& robot, const CameraSpec& camera,
                     const SceneSnapshot& snapshot, bool is_short) {
  const int joint = robot.links.at(static_cast<size_t>(camera.link)).joint;
  std::string text;
  if (joint == kCameraTilt || joint == kCameraPan) {
    text = fmt::format(
        "PAN {} {} {:+3.0f}\xB0", PanText(ToDegrees(snapshot.state.joint[kCameraPan])),
        is_short ? "TLT" : "TILT", Tidy(ToDegrees(snapshot.state.joint[kCameraTilt]), 1));
  }
  if (camera.zoom_most > 1) {
    const double zoom = std::clamp(snapshot.zoom, 1.0, camera.zoom_most);
    text += fmt::format("{}{:4.1f}x", text.empty() ? "" : is_short ? " " : " ZOOM ", zoom);
  }
  return text;
}

}  // namespace

OnScreenText TextOf(const RobotModel& robot, const CameraSpec& camera,
                    const SceneSnapshot& snapshot, int width) {
  const bool is_short = width < kShortBelow;
  OnScreenText text;
  text.name = camera.name;
  std::ranges::transform(text.name, text.name.begin(), [](unsigned char letter) {
    return static_cast<char>(std::toupper(letter));
  });
  text.clock = Clock(snapshot.time);
  text.tilt =
      fmt::format("{} {:+.1f}\xB0 {} {:+.1f}\xB0", is_short ? "P" : "PITCH",
                  Tidy(ToDegrees(snapshot.state.attitude.pitch), 0.1), is_short ? "R" : "ROLL",
                  Tidy(ToDegrees(snapshot.state.attitude.roll), 0.1));
  text.head = HeadText(robot, camera, snapshot, is_short);
  return text;
}

OnScreenData::OnScreenData(int height)
    : letters_(std::max(11, static_cast<int>(std::lround(height / 32.0)))),
      capitals_(std::max(18, static_cast<int>(std::lround(height / 14.0)))),
      margin_(std::max(3, height / 60)) {}

void OnScreenData::Draw(const OnScreenText& text, const PixelView& picture) const {
  const auto right_of = [&](std::string_view line) {
    return picture.width - margin_ - letters_.Width(line);
  };
  const int top = margin_;
  const int bottom = picture.height - margin_ - letters_.line_height() - 4;
  letters_.Draw(text.name, margin_, top, picture);
  letters_.Draw(text.clock, right_of(text.clock), top, picture);
  letters_.Draw(text.tilt, margin_, bottom, picture);
  letters_.Draw(text.head, right_of(text.head), bottom, picture);
  DrawMark((picture.width - letters_.Width(kMark)) / 2, top, picture);
}

/// A red dot, as of a camera that records, and the word.
void OnScreenData::DrawMark(int left, int top, const PixelView& picture) const {
  letters_.Draw(kMark, left + letters_.advance() / 2, top, picture);
  const double radius = letters_.line_height() / 4.0;
  const int middle = top + 2 + letters_.line_height() / 2;
  const auto disc = [&](double r, const std::array<uint8_t, 3>& colour) {
    const int reach = static_cast<int>(std::ceil(r));
    for (int dy = -reach; dy <= reach; ++dy) {
      const int half = static_cast<int>(std::lround(std::sqrt(std::max(0.0, r * r - dy * dy))));
      if (half == 0) continue;
      FillRectangle(picture, left - letters_.advance() / 2 - half, middle + dy, 2 * half, 1,
                    colour);
    }
  };
  disc(radius + 1, kMarkRim);
  disc(radius, kMarkColour);
}

void OnScreenData::DrawNoSignal(const PixelView& picture) const {
  capitals_.Draw(kNoSignal, (picture.width - capitals_.Width(kNoSignal)) / 2,
                 (picture.height - capitals_.line_height()) / 2, picture);
}

}  // namespace eod::sim
