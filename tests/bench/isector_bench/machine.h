#pragma once

#include <string>

namespace eod::bench {

/// Where numbers come from: processor, its vector instruction sets, compiler, load average.
struct Machine {
  std::string processor;
  std::string instruction_sets;
  std::string compiler;
  std::string load;  ///< averages of 1, 5 and 15 minutes
};

Machine ThisMachine();

}  // namespace eod::bench
