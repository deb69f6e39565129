#include "sim/camera/picture_link.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "sim/camera/sensor.h"

namespace eod::sim {
namespace {

constexpr float kClean = 0.9F;          // link quality from which nothing is seen of the link
constexpr int kWorstJpeg = 8;           // quality at the bad end: blocks
constexpr float kLosesStrips = 0.5F;    // link quality below which strips are lost ...
constexpr float kMostStrips = 0.5F;     // ... up to this share of them
constexpr float kLosesPictures = 0.3F;  // and below which pictures are ...
constexpr float kMostPictures = 0.85F;  // ... up to this share of the time
constexpr int kStrip = 16;              // [px] a row of blocks
constexpr auto kFade = std::chrono::milliseconds(240);  // a fade of the radio lasts so long

/// Whether something of probability `share` happens.
bool Happens(uint32_t chance, float share) {
  return static_cast<float>(chance >> 8U) < share * static_cast<float>(1U << 24U);
}

/// 0 at `from` and above, 1 at 0.
float Badness(float quality, float from) { return std::clamp(1 - quality / from, 0.0F, 1.0F); }

}  // namespace

int PictureLink::JpegQuality(float quality, int best) {
  const float share = std::sqrt(Badness(quality, kClean));
  return std::min(
      best, static_cast<int>(std::lround(std::lerp(static_cast<float>(best), kWorstJpeg, share))));
}

void PictureLink::Carry(float quality, TimePoint time, uint32_t seed, const PixelView& picture) {
  if (quality >= 1) {
    arrived_.clear();
    return;
  }
  const size_t row = 4 * static_cast<size_t>(picture.width);
  const size_t size = row * static_cast<size_t>(picture.height);
  if (arrived_.size() == size) {
    const auto fade = static_cast<uint32_t>(time.time_since_epoch() / kFade);
    const auto moment = static_cast<uint32_t>(ToUtime(time));
    const float lost = kMostPictures * Badness(quality, kLosesPictures);
    if (IsLost(quality) || Happens(Hash(fade, seed), lost)) {
      std::memcpy(picture.first, arrived_.data(), size);
      return;
    }
    LoseStrips(quality, Hash(moment, seed + 1), picture);
  }
  arrived_.assign(picture.first, picture.first + size);
}

void PictureLink::LoseStrips(float quality, uint32_t chance, const PixelView& picture) const {
  const float share = kMostStrips * Badness(quality, kLosesStrips);
  if (share == 0) return;
  const size_t row = 4 * static_cast<size_t>(picture.width);
  for (int top = 0; top < picture.height; top += kStrip) {
    const uint32_t strip = Hash(static_cast<uint32_t>(top), chance);
    if (!Happens(strip, share)) continue;
    // A decoder that lost its place: what follows stands some blocks aside.
    const size_t aside = 4 * static_cast<size_t>(kStrip) * (strip % 6);
    for (int y = top; y < std::min(top + kStrip, picture.height); ++y) {
      const uint8_t* old = arrived_.data() + (picture.Row(y) - picture.first);
      std::memcpy(picture.Row(y) + aside, old, row - aside);
      std::memcpy(picture.Row(y), old + row - aside, aside);
    }
  }
}

}  // namespace eod::sim
