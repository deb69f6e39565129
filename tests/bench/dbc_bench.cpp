// Cost of a frame and of a file, in time: build/<preset>/tests/dbc_bench.

#include <array>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "dbc/box_codec.h"
#include "dbc/control_map.h"
#include "dbc/database.h"
#include "dbc/signal_plan.h"

namespace eod::dbc {
namespace {

/// Eight signals that fill eight bytes, none of them byte-aligned throughout.
std::vector<SignalPlan> EightSignals(ByteOrder order) {
  std::vector<SignalPlan> plans;
  constexpr std::array kLengths = {4, 12, 3, 13, 1, 15, 6, 10};
  int position = 0;
  for (const int length : kLengths) {
    Signal signal;
    signal.name = "S";
    signal.byte_order = order;
    signal.start_bit = order == ByteOrder::kIntel ? position : position / 8 * 8 + 7 - position % 8;
    signal.length = length;
    signal.is_signed = length > 8;
    signal.factor = 0.1;
    signal.offset = -4;
    plans.emplace_back(signal, 8);
    position += length;
  }
  return plans;
}

void DecodeFrame(benchmark::State& state, ByteOrder order) {
  const std::vector<SignalPlan> plans = EightSignals(order);
  std::array<uint8_t, 8> payload{0x98, 0x20, 0x05, 0x11, 0xC8, 0x00, 0x78, 0x10};
  std::array<int64_t, 8> raw{};
  std::array<double, 8> physical{};
  for ([[maybe_unused]] auto _ : state) {
    benchmark::DoNotOptimize(payload.data());
    benchmark::ClobberMemory();
    for (size_t i = 0; i < plans.size(); ++i) {
      raw[i] = plans[i].DecodeRaw(payload);
      physical[i] = plans[i].ToPhysical(raw[i]);
    }
    benchmark::DoNotOptimize(raw.data());
    benchmark::DoNotOptimize(physical.data());
    benchmark::ClobberMemory();
  }
}

void EncodeFrame(benchmark::State& state, ByteOrder order) {
  const std::vector<SignalPlan> plans = EightSignals(order);
  std::array<uint8_t, 8> payload{};
  std::array<double, 8> physical{1, -3, 0.5, 60, 0, -4, 2, 7};
  for ([[maybe_unused]] auto _ : state) {
    benchmark::DoNotOptimize(physical.data());
    benchmark::ClobberMemory();
    for (size_t i = 0; i < plans.size(); ++i)
      plans[i].EncodeRaw(plans[i].ToRaw(physical[i]), payload);
    benchmark::DoNotOptimize(payload.data());
    benchmark::ClobberMemory();
  }
}

BENCHMARK_CAPTURE(DecodeFrame, intel, ByteOrder::kIntel);
BENCHMARK_CAPTURE(DecodeFrame, motorola, ByteOrder::kMotorola);
BENCHMARK_CAPTURE(EncodeFrame, intel, ByteOrder::kIntel);
BENCHMARK_CAPTURE(EncodeFrame, motorola, ByteOrder::kMotorola);

std::filesystem::path MapFile() {
  return std::filesystem::path(EOD_DATA_DIR) / "dbc/control_box.map.toml";
}

/// 15 signals, counter, CRC.
void CodecEncodeSafety(benchmark::State& state) {
  const ControlMap map = LoadControlMap(MapFile());
  BoxCodec codec(LoadDatabase(map.dbc), map);
  const PanelState panel;
  for ([[maybe_unused]] auto _ : state)
    benchmark::DoNotOptimize(codec.Encode(BoxMessage::kSafety, panel));
}
BENCHMARK(CodecEncodeSafety);

/// Encodes and decodes, as a frame must be new to be taken.
void CodecSafetyBothWays(benchmark::State& state) {
  const ControlMap map = LoadControlMap(MapFile());
  BoxCodec codec(LoadDatabase(map.dbc), map);
  PanelState panel;
  for ([[maybe_unused]] auto _ : state) {
    benchmark::DoNotOptimize(codec.Decode(*codec.Encode(BoxMessage::kSafety, panel), panel));
  }
}
BENCHMARK(CodecSafetyBothWays);

/// ROB_STATUS: 32 signals, most of them single bits.
void CodecStatusBothWays(benchmark::State& state) {
  const ControlMap map = LoadControlMap(MapFile());
  BoxCodec codec(LoadDatabase(map.dbc), map);
  RobotFeedback feedback;
  for ([[maybe_unused]] auto _ : state) {
    benchmark::DoNotOptimize(
        codec.Decode(*codec.Encode(RobotMessage::kStatus, feedback), feedback));
  }
}
BENCHMARK(CodecStatusBothWays);

void LoadDbc(benchmark::State& state) {
  std::ifstream stream(LoadControlMap(MapFile()).dbc);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  for ([[maybe_unused]] auto _ : state)
    benchmark::DoNotOptimize(ParseDatabase(text, "control_box.dbc"));
  state.SetBytesProcessed(static_cast<int64_t>(state.iterations() * text.size()));
}
BENCHMARK(LoadDbc);

void LoadMap(benchmark::State& state) {
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(LoadControlMap(MapFile()));
}
BENCHMARK(LoadMap);

}  // namespace
}  // namespace eod::dbc

BENCHMARK_MAIN();
