#pragma once

#include <cstdint>

#include "sim/segments/block_tree.h"

namespace eod::sim {

/// What the arithmetic runs on. Every set gives the same candidates and so the same hits.
enum class InstructionSet : uint8_t {
  kPlain,  ///< what every processor of this kind has: SSE2 on x86-64, plain C++ elsewhere
  kAvx2,
};

/// The widest set that this processor has.
InstructionSet BestInstructionSet();

/// Up to eight segments that are culled together, relative to one origin, in float [m].
struct alignas(32) SegmentPacket {
  float start[3][8];
  float way[3][8];  ///< from start to end
  float low[3];     ///< box round all of them, rounded outwards
  float high[3];
  /// Boxes round places 0 and 1, 2 and 3 and so on, rounded outwards: the six lines of a BUMP are
  /// three thin boxes in a thick one.
  float pair_low[4][3];
  float pair_high[4][3];
  float longest = 0;   ///< length of the longest way
  float diagonal = 0;  ///< of the box
  int pairs = 0;       ///< boxes in use
  uint32_t lanes = 0;  ///< bit i: place i is used
};

/// One long segment, in float, with what a slab test needs.
struct Line {
  float start[3];    ///< [m] module's local frame
  float inverse[3];  ///< 1 / direction; huge instead of infinite
  float slack;       ///< [m] by which rounding can have moved the line
};

/// The same line where it comes near a block, relative to the block's origin.
struct LinePiece {
  float start[3];  ///< [m]
  float way[3];    ///< [m] from there to the end
  float way_length;
};

/// A triangle of a block, and the segments of a packet that may meet it.
struct Candidate {
  uint8_t place;
  uint8_t lanes;
};

/// Boxes of many blocks, coordinate by coordinate, padded to a multiple of 8 by boxes that nothing
/// meets [m].
struct BoxColumns {
  const float* low[3];
  const float* high[3];
  int count = 0;  ///< a multiple of 8
};

/// The arithmetic of one instruction set. All tests are conservative: rounding never loses a
/// candidate, the exact test decides.
struct Kernels {
  /// Indices of the boxes that meet a pair of the packet; returns how many. `found` has room for
  /// all.
  int (*OverlappingBoxes)(const BoxColumns& boxes, const SegmentPacket& packet, int32_t* found);
  /// Bit mask of the node's children that meet the box low..high.
  uint32_t (*OverlappingChildren)(const Node& node, const float* low, const float* high);
  /// Bit mask of the children that the line enters before `reach`, and where.
  uint32_t (*EnteredChildren)(const Node& node, const Line& line, float reach, float* enter);
  /// Triangles of the block that the packet's segments may meet; returns how many, at most 16.
  /// `offset` is the block's origin relative to the packet's, `error` [m] bounds the rounding of
  /// all coordinates involved. `tested` counts triangles offered, times segments.
  int (*TestPacket)(const Block& block, const BlockPlace& place, const SegmentPacket& packet,
                    const float* offset, float error, Candidate* found, uint64_t& tested);
  /// Bit mask of the block's triangles that the line may meet.
  uint32_t (*TestLine)(const Block& block, const BlockPlace& place, const LinePiece& line,
                       float error);
};

/// Throws std::invalid_argument if this processor lacks it.
const Kernels& KernelsFor(InstructionSet instruction_set);

extern const Kernels kPlainKernels;
#if defined(__x86_64__)
extern const Kernels kAvx2Kernels;
#endif

}  // namespace eod::sim
