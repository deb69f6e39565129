#pragma once

#include <cstddef>
#include <cstdint>

#include "sim/segments/block_tree.h"

namespace eod::sim {

/// What the arithmetic runs on. Every set gives the same hits; how many near misses the exact test
/// has to refuse may differ.
enum class InstructionSet : uint8_t {
  kPlain,  ///< what every processor of this kind has: SSE2 on x86-64, plain C++ elsewhere
  kAvx2,   ///< and the bit manipulation of the same processors: Haswell, Zen and later
};

/// The widest set that this processor has.
InstructionSet BestInstructionSet();

/// Up to eight segments that are culled together, relative to one origin, in float [m]. They stand
/// in pairs: segments 0 and 1, 2 and 3 and so on, at places that are four apart.
struct alignas(32) SegmentPacket {
  float start[3][8];
  float way[3][8];  ///< from start to end
  /// Boxes round the pairs, rounded outwards: the six lines of a BUMP are three thin boxes in a
  /// thick one.
  float pair_low[3][4];
  float pair_high[3][4];
  float low[3];  ///< box round all of them, rounded outwards
  float high[3];
  float longest;    ///< length of the longest way
  float diagonal;   ///< of the box
  int pairs;        ///< in use
  uint32_t places;  ///< bit i: place i is in use
  uint32_t segments;

  static constexpr int PlaceOf(int segment) { return segment / 2 + 4 * (segment % 2); }
  static constexpr int SegmentAt(int place) { return 2 * (place % 4) + place / 4; }
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

/// Bounds of the rounding errors in the test of a segment and a triangle, by Moller and Trumbore:
/// of its sides and determinant L (side[0] D + side[1]), of its range that and range[0] D +
/// range[1], where L is the length of the segment and D how far it starts from the triangle [m].
struct SlackTerms {
  float side[2];
  float range[2];

  /// For triangles with edges up to `edge` [m], every coordinate difference wrong by up to `error`
  /// [m].
  static constexpr SlackTerms Of(float edge, float error) {
    // Unit roundoff of float times the operations of a triple product, and something to spare.
    constexpr float kRounding = 16 * 6e-8F;
    // A corner may be farther than the triangle by its edge, and by the errors of both.
    const float more = edge + 2 * error;
    const float side = error + kRounding * edge;
    const float range = edge * (2 * error + kRounding * edge);
    return {{side, side * more + edge * (5 * error + 2 * kRounding * edge)},
            {range, range * more + edge * edge * error}};
  }
};

/// A block near a reader.
struct NearBlock {
  int32_t block;       ///< in BlockTree::blocks
  uint32_t triangles;  ///< bit by bit: places in use
  float offset[3];     ///< [m] of its origin from the reader's
  float low[3];        ///< [m] offset less the error of all coordinates in a test
  float high[3];       ///< [m] offset plus that error
  SlackTerms slack;
};

/// A box of a list that a packet comes near, and which of its pairs do: bit 8 i for pair i.
struct NearBox {
  int32_t index;
  int32_t packet;  ///< in the list of packets
  uint32_t pairs;
};

/// A triangle of a block, and the places of a packet whose segments may meet it.
struct Candidate {
  int32_t box;       ///< index in the list that was tested
  int16_t triangle;  ///< place in the block
  int16_t places;    ///< bit by bit
};

/// What the way of packets through many blocks at once takes.
struct PacketWork {
  static constexpr int kMostBoxes = 128;  ///< near boxes at once
  struct Near {
    const float* corner;  ///< first coordinate of its first corner
    int32_t box;
    int32_t triangle;  ///< place in the block
  };
  float side_slack[kMostBoxes], range_slack[kMostBoxes];
  Near near[kMostBoxes * kBlockSize];
  Candidate candidates[kMostBoxes * kBlockSize];
};

/// Boxes of many blocks, coordinate by coordinate, padded to a multiple of 8 by boxes that nothing
/// meets [m].
struct BoxColumns {
  const float* low[3];
  const float* high[3];
  int first = 0;  ///< number of the first box
  int count = 0;  ///< a multiple of 8
};

/// A segment's numbers: start, direction and length one after the other, as they begin a
/// SegmentQuery.
struct SegmentNumbers {
  static constexpr int kStart = 0, kDirection = 3, kLength = 6;
};

/// The arithmetic of one instruction set. All tests are conservative: rounding never loses a
/// candidate, the exact test decides.
struct Kernels {
  /// Fills a packet with 1..8 segments of short length, relative to `origin` (x, y, z and any
  /// number), and grows its boxes by `margin` [m]. `segments` points to SegmentNumbers, one a
  /// place; unused places repeat their partner, or the first segment. False, and no packet, unless
  /// all are castable beyond doubt: finite, unit to 1e-6, of positive length.
  bool (*pack)(const double* const* segments, int count, const double* origin, float margin,
               SegmentPacket& packet);
  /// Boxes that meet a pair of the packet of that number; returns how many. `found` has room for
  /// all.
  int (*overlapping_boxes)(const BoxColumns& boxes, const SegmentPacket& packet, int number,
                           NearBox* found);
  /// Bit mask of the node's children that meet the box low..high.
  uint32_t (*overlapping_children)(const Node& node, const float* low, const float* high);
  /// Bit mask of the children that the line enters before `reach`, and where.
  uint32_t (*entered_children)(const Node& node, const Line& line, float reach, float* enter);
  /// Triangles that the packets' segments may meet in their near boxes, which are `count` <=
  /// PacketWork::kMostBoxes; returns how many entries of `work.candidates` were filled. Packets are
  /// `stride` bytes apart. `tested` counts triangles offered, times segments.
  int (*test_packets)(const Block* blocks, const NearBlock* near, const NearBox* boxes, int count,
                      const SegmentPacket* packets, size_t stride, PacketWork& work,
                      uint64_t& tested);
  /// Bit mask of the block's triangles that the line may meet.
  uint32_t (*test_line)(const Block& block, const BlockPlace& place, const LinePiece& line,
                        float error);
};

/// Throws std::invalid_argument if this processor lacks it.
const Kernels& KernelsFor(InstructionSet instruction_set);

extern const Kernels kPlainKernels;
#if defined(__x86_64__)
extern const Kernels kAvx2Kernels;
#endif

}  // namespace eod::sim
