#include "sim/camera/sensor.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/camera/noise.h"

namespace eod::sim {
namespace {

constexpr double kCornerLight = 0.80;  // of the middle's, in a corner
constexpr double kFullGain = 90;       // mean brightness below which the gain goes up
constexpr double kMostGain = 9;
constexpr double kBaseNoise = 1.1;  // standard deviation [0..255] in daylight
constexpr double kFaultyNoise = 34;
constexpr int kDeviation = 32;        // of the table
constexpr size_t kTable = 1U << 16U;  // [byte]
constexpr size_t kLongestRow = 4 * 4096;

/// Noise as it comes out of a camera: smoothed along the row by its own filters, and more of light
/// than of colour. Four bytes a pixel; read at any place.
std::vector<int8_t> MakeNoise() {
  const size_t pixels = (kTable + kLongestRow) / 4;
  const auto normal = [](uint32_t i, uint32_t channel) {
    // Irwin and Hall: the sum of 12 even ones has deviation 1.
    double sum = -6;
    for (uint32_t k = 0; k < 12; ++k) {
      sum += Hash(12 * i + k, channel) / 4294967296.0;
    }
    return sum;
  };
  std::array<std::vector<double>, 4> raw;  // light, then the three colours
  for (uint32_t channel = 0; channel < 4; ++channel) {
    for (uint32_t i = 0; i < pixels + 1; ++i) raw[channel].push_back(normal(i, channel));
  }
  std::vector<int8_t> noise(4 * pixels);
  for (size_t i = 0; i < pixels; ++i) {
    const auto smooth = [&](size_t channel) {
      return 0.8 * raw[channel][i] + 0.6 * raw[channel][i + 1];  // squares: 1
    };
    for (size_t channel = 0; channel < 3; ++channel) {
      const double value = 0.86 * smooth(0) + 0.51 * smooth(channel + 1);
      noise[4 * i + channel] =
          static_cast<int8_t>(std::clamp(std::lround(kDeviation * value), -127L, 127L));
    }
  }
  return noise;
}

const std::vector<int8_t>& Noise() {
  static const std::vector<int8_t> noise = MakeNoise();
  return noise;
}

/// Light along one axis, 256 in the middle; both axes together give a corner its share.
std::vector<uint16_t> Falloff(int length, int repeat) {
  std::vector<uint16_t> light;
  for (int i = 0; i < length; ++i) {
    const double off = (i + 0.5) / length * 2 - 1;
    const double share = 1 - (1 - std::sqrt(kCornerLight)) * off * off;
    light.insert(light.end(), static_cast<size_t>(repeat),
                 static_cast<uint16_t>(std::lround(256 * share)));
  }
  return light;
}

/// One row of bytes. All 16 bit wide, so that it is done eight at a time.
void ExposeRow(uint8_t* __restrict row, size_t bytes, const uint16_t* __restrict columns,
               uint16_t gain, const int8_t* __restrict noise, int16_t amplitude) {
  for (size_t i = 0; i < bytes; ++i) {
    const auto light = static_cast<uint16_t>(row[i] * columns[i]);
    const auto lit = static_cast<int16_t>((static_cast<uint32_t>(light) * gain) >> 16U);
    const auto grain = static_cast<int16_t>(static_cast<int16_t>(noise[i] * amplitude) >> 7);
    const auto value = static_cast<int16_t>(lit + grain);
    row[i] = static_cast<uint8_t>(std::clamp<int16_t>(value, 0, 255));
  }
}

}  // namespace

uint32_t Hash(uint32_t a, uint32_t b) {
  uint32_t h = a * 0x9E3779B1U ^ (b + 0x7F4A7C15U) * 0x85EBCA6BU;
  h ^= h >> 15U;
  h *= 0x2C1B3C6DU;
  h ^= h >> 12U;
  h *= 0x297A2D39U;
  return h ^ h >> 15U;
}

double MeanBrightness(const PixelView& picture) {
  constexpr int kStep = 16;
  int64_t sum = 0;
  int64_t count = 0;
  for (int row = kStep / 2; row < picture.height; row += kStep) {
    const uint8_t* line = picture.Row(row);
    for (int x = kStep / 2; x < picture.width; x += kStep) {
      sum += line[4 * x] + line[4 * x + 1] + line[4 * x + 2];
      count += 3;
    }
  }
  return count == 0 ? 0 : static_cast<double>(sum) / static_cast<double>(count);
}

Sensor::Sensor(int width, int height) : columns_(Falloff(width, 4)), rows_(Falloff(height, 1)) {}

double Sensor::NoiseOf(double brightness) {
  return kBaseNoise * std::clamp(kFullGain / std::max(brightness, 1e-3), 1.0, kMostGain);
}

void Sensor::Expose(const Exposure& exposure, const PixelView& picture) {
  // Pictures hold the square root of light, so a stop is half as much of a factor.
  const double factor = std::clamp(std::exp2(static_cast<double>(exposure.stops) / 2), 0.0, 100.0);
  const double wanted = exposure.is_noisy ? kFaultyNoise : NoiseOf(MeanBrightness(picture));
  const auto amplitude = static_cast<int16_t>(std::lround(wanted * 128 / kDeviation));
  const std::vector<int8_t>& noise = Noise();
  for (int row = 0; row < picture.height; ++row) {
    const double gain = factor * rows_[static_cast<size_t>(row)];
    const size_t place = Hash(exposure.seed, static_cast<uint32_t>(row)) % (kTable / 4) * 4;
    ExposeRow(picture.Row(row), 4 * static_cast<size_t>(picture.width), columns_.data(),
              static_cast<uint16_t>(std::min(gain, 32767.0)), &noise[place], amplitude);
  }
}

}  // namespace eod::sim
