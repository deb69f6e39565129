#include "tests/bench/isector_bench/machine.h"

#include <array>
#include <cstdlib>
#include <fstream>

#include <fmt/format.h>

namespace eod::bench {

namespace {

std::string Processor() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  }
  return "unknown processor";
}

std::string InstructionSets() {
  std::string sets = "x86-64";
  if (__builtin_cpu_supports("sse4.2")) sets += ", SSE4.2";
  if (__builtin_cpu_supports("avx")) sets += ", AVX";
  if (__builtin_cpu_supports("avx2")) sets += ", AVX2";
  if (__builtin_cpu_supports("fma")) sets += ", FMA";
  if (__builtin_cpu_supports("avx512f")) sets += ", AVX-512F";
  return sets;
}

std::string Compiler() {
#ifdef NDEBUG
  return "g++ " __VERSION__ ", optimised";
#else
  return "g++ " __VERSION__ ", WITH ASSERTIONS: times mean nothing, build the release preset";
#endif
}

}  // namespace

Machine ThisMachine() {
  std::array<double, 3> load{};
  getloadavg(load.data(), static_cast<int>(load.size()));
  return {.processor = Processor(),
          .instruction_sets = InstructionSets(),
          .compiler = Compiler(),
          .load = fmt::format("{:.2f} {:.2f} {:.2f}", load[0], load[1], load[2])};
}

}  // namespace eod::bench
