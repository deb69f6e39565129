#include "recorder/picture_rate.h"

#include <algorithm>

namespace eod::recorder {
namespace {

constexpr Duration kNotChosen = std::chrono::milliseconds(500);  // no picture for so long
constexpr Duration kSecond = std::chrono::seconds(1);

}  // namespace

void PictureRate::OnPicture(TimePoint time, TimePoint last_of_any) {
  if (frames_ > 0) {
    const Duration gap = time - newest_.back();
    shown_ += gap < kNotChosen ? gap : time - last_of_any;
  }
  ++frames_;
  newest_.push_back(time);
  while (time - newest_.front() > kSecond) newest_.pop_front();
}

double PictureRate::mean_fps() const {
  return shown_ > Duration::zero() ? static_cast<double>(frames_ - 1) / ToSeconds(shown_) : 0;
}

double PictureRate::FpsAt(TimePoint now) const {
  return static_cast<double>(
      std::ranges::count_if(newest_, [now](TimePoint time) { return now - time < kSecond; }));
}

}  // namespace eod::recorder
