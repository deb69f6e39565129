#include "sim/segments/kernels_code.h"

namespace eod::sim {

const Kernels kPlainKernels = {Pack,        OverlappingBoxes, OverlappingChildren, EnteredChildren,
                               TestPackets, TestLine};

}  // namespace eod::sim
