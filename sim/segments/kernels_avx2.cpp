#include "sim/segments/kernels_code.h"

namespace eod::sim {

const Kernels kAvx2Kernels = {Pack,        OverlappingBoxes, OverlappingChildren, EnteredChildren,
                              TestPackets, TestLine};

}  // namespace eod::sim
