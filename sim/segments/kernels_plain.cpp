#include "sim/segments/kernels_code.h"

namespace eod::sim {

const Kernels kPlainKernels = {Pack,       OverlappingBoxes, OverlappingChildren, EnteredChildren,
                               TestPacket, TestLine};

}  // namespace eod::sim
