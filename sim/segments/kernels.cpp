#include "sim/segments/kernels.h"

#include <stdexcept>

namespace eod::sim {

InstructionSet BestInstructionSet() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
      __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2") &&
      __builtin_cpu_supports("popcnt")) {
    return InstructionSet::kAvx2;
  }
#endif
  return InstructionSet::kPlain;
}

const Kernels& KernelsFor(InstructionSet instruction_set) {
#if defined(__x86_64__)
  if (instruction_set == InstructionSet::kAvx2) {
    if (BestInstructionSet() != InstructionSet::kAvx2) {
      throw std::invalid_argument("this processor has no AVX2");
    }
    return kAvx2Kernels;
  }
#endif
  return kPlainKernels;
}

}  // namespace eod::sim
