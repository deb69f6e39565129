// The kernels' arithmetic, compiled once for each instruction set: included by kernels_*.cpp alone.
// Nothing but plain arrays in and out, so that no inline function of a library is compiled for a
// processor that may not be there.
#pragma once

#include "sim/segments/kernels.h"
#include "sim/segments/lanes.h"

namespace eod::sim {
namespace {

/// Bounds of the rounding errors in the segment-triangle test.
struct Slack {
  float side;   ///< of u, v and the determinant
  float range;  ///< of t and the determinant
};

/// Lanes whose segment (start, way) may meet the triangle (corner, edges), by Moller and Trumbore,
/// "Fast, Minimum Storage Ray/Triangle Intersection", 1997.
inline uint32_t MayMeet(const Points& start, const Points& way, const Points& corner,
                        const Points& edge_1, const Points& edge_2, const Slack& slack) {
  const Lanes sign_bit = Lanes::All(-0.0F);
  const Points s = start - corner;
  const Points p = Cross(way, edge_2);
  const Lanes determinant = Dot(edge_1, p);
  const Lanes sign = determinant & sign_bit;
  const Lanes size = determinant ^ sign;
  const Lanes u = Dot(s, p) ^ sign;
  const Points q = Cross(s, edge_1);
  const Lanes v = Dot(way, q) ^ sign;
  const Lanes t = Dot(edge_2, q) ^ sign;
  const Lanes side = Lanes::All(slack.side), range = Lanes::All(slack.range);
  const Lanes least_side = Lanes::All(-slack.side), least_range = Lanes::All(-slack.range);
  return Bits((least_side <= u) & (least_side <= v) & (u + v <= size + side) & (least_range <= t) &
              (t <= size + range));
}

/// Boxes low..high that meet the box bottom..top.
inline Lanes Overlap(const Points& low, const Points& high, const Points& bottom,
                     const Points& top) {
  return (low.x <= top.x) & (bottom.x <= high.x) & (low.y <= top.y) & (bottom.y <= high.y) &
         (low.z <= top.z) & (bottom.z <= high.z);
}

inline Points PairLow(const SegmentPacket& packet, int pair) {
  return {Lanes::All(packet.pair_low[0][pair]), Lanes::All(packet.pair_low[1][pair]),
          Lanes::All(packet.pair_low[2][pair])};
}

inline Points PairHigh(const SegmentPacket& packet, int pair) {
  return {Lanes::All(packet.pair_high[0][pair]), Lanes::All(packet.pair_high[1][pair]),
          Lanes::All(packet.pair_high[2][pair])};
}

/// A packet's numbers, coordinate by coordinate: firsts of the pairs, then seconds. The fourth
/// column of a way is its length squared.
struct PacketColumns {
  Four start[2][4], way[2][4];

  PacketColumns(const double* const* segments, const double* origin) {
    Four starts[8], ways[8];
    for (int i = 0; i < 8; ++i) {
      const double* at = segments[i];
      starts[i] = RoundedDifference(at + SegmentNumbers::kStart, origin);
      ways[i] = RoundedProduct(at + SegmentNumbers::kDirection, at[SegmentNumbers::kLength]);
    }
    for (int half = 0; half < 2; ++half) {
      Transpose(starts + 4 * half, start[half]);
      Transpose(ways + 4 * half, way[half]);
    }
  }

  /// Whether all are finite and as long as they say. Not finite times 0 is NaN, and equals nothing.
  bool AreValid() const {
    // The latter so that a length of 0, which says nothing of the direction, is not beyond doubt.
    constexpr float kUnit = 1e-6F, kTiny = 1e-30F;
    bool valid = true;
    for (int half = 0; half < 2; ++half) {
      const Four squared_length = way[half][3];
      Four deviation = -squared_length;
      for (int axis = 0; axis < 3; ++axis) {
        deviation += way[half][axis] * way[half][axis] + start[half][axis] * 0.0F;
      }
      valid &= AllWithin(deviation, squared_length * kUnit - kTiny);
    }
    return valid;
  }
};

inline void PackBoxes(const PacketColumns& columns, float margin, SegmentPacket& packet) {
  const Four margins = {margin, margin, margin, margin};
  packet.diagonal = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const Four one = columns.start[0][axis], one_end = one + columns.way[0][axis];
    const Four other = columns.start[1][axis], other_end = other + columns.way[1][axis];
    const Four low = Least(Least(one, one_end), Least(other, other_end)) - margins;
    const Four high = Largest(Largest(one, one_end), Largest(other, other_end)) + margins;
    Store(one, packet.start[axis]);
    Store(other, packet.start[axis] + 4);
    Store(columns.way[0][axis], packet.way[axis]);
    Store(columns.way[1][axis], packet.way[axis] + 4);
    Store(low, packet.pair_low[axis]);
    Store(high, packet.pair_high[axis]);
    packet.low[axis] = LeastOf(low);
    packet.high[axis] = LargestOf(high);
    packet.diagonal += packet.high[axis] - packet.low[axis];
  }
}

bool Pack(const double* const* segments, int count, const double* origin, float margin,
          SegmentPacket& packet) {
  packet.pairs = (count + 1) / 2;
  packet.segments = static_cast<uint32_t>(count);
  packet.places = ((1u << packet.pairs) - 1) | ((1u << count / 2) - 1) << 4;
  double longest = 0, shortest = 0;
  for (int place = 0; place < 8; ++place) {
    const double length = segments[place][SegmentNumbers::kLength];
    longest = length > longest ? length : longest;
    shortest = length < shortest ? length : shortest;
  }
  packet.longest = static_cast<float>(longest) * (1 + 1e-6F);
  const PacketColumns columns(segments, origin);
  PackBoxes(columns, margin, packet);
  return shortest >= 0 && columns.AreValid();
}

int OverlappingBoxes(const BoxColumns& boxes, const SegmentPacket& packet, int number,
                     NearBox* found) {
  const Points bottom = AllPoints(packet.low), top = AllPoints(packet.high);
  int count = 0;
  for (int at = 0; at < boxes.count; at += Lanes::kWidth) {
    const Points low = {Lanes::Load(boxes.low[0] + at), Lanes::Load(boxes.low[1] + at),
                        Lanes::Load(boxes.low[2] + at)};
    const Points high = {Lanes::Load(boxes.high[0] + at), Lanes::Load(boxes.high[1] + at),
                         Lanes::Load(boxes.high[2] + at)};
    if (Bits(Overlap(low, high, bottom, top)) == 0) continue;
    uint32_t near = 0;  // a byte a pair, a bit a box
    for (int pair = 0; pair < packet.pairs; ++pair) {
      near |= Bits(Overlap(low, high, PairLow(packet, pair), PairHigh(packet, pair))) << 8 * pair;
    }
    uint32_t any = near | near >> 16;
    any = (any | any >> 8) & 0xFF;
    for (; any != 0; any &= any - 1) {
      const int i = __builtin_ctz(any);
      found[count++] = {boxes.first + at + i, number, near >> i & 0x01010101u};
    }
  }
  return count;
}

uint32_t OverlappingChildren(const Node& node, const float* low, const float* high) {
  const Points bottom = AllPoints(low), top = AllPoints(high);
  uint32_t bits = 0;
  for (int at = 0; at < kFanOut; at += Lanes::kWidth) {
    const Points node_low = LoadPoints(node.low, at), node_high = LoadPoints(node.high, at);
    bits |= Bits(Overlap(node_low, node_high, bottom, top)) << at;
  }
  return bits;
}

uint32_t EnteredChildren(const Node& node, const Line& line, float reach, float* enter) {
  const Points start = AllPoints(line.start), inverse = AllPoints(line.inverse);
  const Lanes slack = Lanes::All(line.slack);
  // A range is at most this much too large or too small: three roundings.
  const Lanes more = Lanes::All(1 + 4 * 6e-8F), less = Lanes::All(1 - 4 * 6e-8F);
  uint32_t bits = 0;
  for (int at = 0; at < kFanOut; at += Lanes::kWidth) {
    const Points node_low = LoadPoints(node.low, at), node_high = LoadPoints(node.high, at);
    Lanes first = Lanes::All(0), last = Lanes::All(reach);
    const auto cut = [&](Lanes low, Lanes high, Lanes from, Lanes factor) {
      const Lanes a = (low - slack - from) * factor, b = (high + slack - from) * factor;
      first = Largest(first, Least(a, b));
      last = Least(last, Largest(a, b));
    };
    cut(node_low.x, node_high.x, start.x, inverse.x);
    cut(node_low.y, node_high.y, start.y, inverse.y);
    cut(node_low.z, node_high.z, start.z, inverse.z);
    first = first * less;
    first.Store(enter + at);
    bits |= Bits(first <= last * more) << at;
  }
  return bits;
}

/// Some triangles of a block side by side.
struct TriangleLanes {
  Points a, b, c;

  TriangleLanes(const Block& block, int at)
      : a(LoadPoints(block.corner[0], at)),
        b(LoadPoints(block.corner[1], at)),
        c(LoadPoints(block.corner[2], at)) {}
  Points Low() const {
    return {Least(Least(a.x, b.x), c.x), Least(Least(a.y, b.y), c.y), Least(Least(a.z, b.z), c.z)};
  }
  Points High() const {
    return {Largest(Largest(a.x, b.x), c.x), Largest(Largest(a.y, b.y), c.y),
            Largest(Largest(a.z, b.z), c.z)};
  }
};

inline const SegmentPacket& PacketOf(const SegmentPacket* packets, size_t stride, int number) {
  const char* first = reinterpret_cast<const char*>(packets);
  return *reinterpret_cast<const SegmentPacket*>(first + static_cast<size_t>(number) * stride);
}

/// The triangles of the boxes that come near a pair.
int CullTriangles(const Block* blocks, const NearBlock* near, const NearBox* boxes, int count,
                  const SegmentPacket* packets, size_t stride, PacketWork& work, uint64_t& tested) {
  int all = 0;
  for (int i = 0; i < count; ++i) {
    const SegmentPacket& packet = PacketOf(packets, stride, boxes[i].packet);
    const NearBlock& block = near[boxes[i].index];
    const Block& corners = blocks[block.block];
    work.side_slack[i] =
        packet.longest * (block.slack.side[0] * packet.diagonal + block.slack.side[1]);
    work.range_slack[i] =
        block.slack.range[0] * packet.diagonal + block.slack.range[1] + work.side_slack[i];
    constexpr int kParts = kBlockSize / Lanes::kWidth;
    Points low[kParts], high[kParts];
    Lanes meets[kParts];
    for (int part = 0; part < kParts; ++part) {
      const TriangleLanes triangle(corners, part * Lanes::kWidth);
      low[part] = triangle.Low() + AllPoints(block.low);
      high[part] = triangle.High() + AllPoints(block.high);
      meets[part] = Lanes::All(0);
    }
    for (uint32_t rest = boxes[i].pairs; rest != 0; rest &= rest - 1) {
      const int pair = __builtin_ctz(rest) / 8;
      const Points bottom = PairLow(packet, pair), top = PairHigh(packet, pair);
      for (int part = 0; part < kParts; ++part) {
        meets[part] = meets[part] | Overlap(low[part], high[part], bottom, top);
      }
    }
    uint32_t triangles = 0;
    for (int part = 0; part < kParts; ++part)
      triangles |= Bits(meets[part]) << part * Lanes::kWidth;
    triangles &= block.triangles;
    tested += static_cast<uint64_t>(__builtin_popcount(triangles)) * packet.segments;
    for (; triangles != 0; triangles &= triangles - 1) {
      const int triangle = __builtin_ctz(triangles);
      work.near[all++] = {corners.corner[0][0] + triangle, i, triangle};
    }
  }
  return all;
}

/// Corner 0, 1 or 2 of the triangle whose first coordinate is at `first`.
inline Points CornerOf(const float* first, int corner) {
  const float* at = first + 3 * kBlockSize * corner;
  return {Lanes::All(at[0]), Lanes::All(at[kBlockSize]), Lanes::All(at[2 * kBlockSize])};
}

int TestPackets(const Block* blocks, const NearBlock* near, const NearBox* boxes, int count,
                const SegmentPacket* packets, size_t stride, PacketWork& work, uint64_t& tested) {
  const int all = CullTriangles(blocks, near, boxes, count, packets, stride, work, tested);
  int found = 0;
  for (int i = 0; i < all; ++i) {
    const auto& [first, box, triangle] = work.near[i];
    const SegmentPacket* packet = &PacketOf(packets, stride, boxes[box].packet);
    const Slack slack = {work.side_slack[box], work.range_slack[box]};
    const Points a = CornerOf(first, 0);
    const Points edge_1 = CornerOf(first, 1) - a, edge_2 = CornerOf(first, 2) - a;
    const Points from = a + AllPoints(near[boxes[box].index].offset);
    uint32_t places = 0;
    for (int at = 0; at < 8; at += Lanes::kWidth) {
      places |= MayMeet(LoadPoints(packet->start, at), LoadPoints(packet->way, at), from, edge_1,
                        edge_2, slack)
                << at;
    }
    places &= packet->places;
    // Without a branch: guessing wrong would cost more than the test.
    work.candidates[found] = {box, static_cast<int16_t>(triangle), static_cast<int16_t>(places)};
    found += places != 0 ? 1 : 0;
  }
  return found;
}

uint32_t TestLine(const Block& block, const BlockPlace& place, const LinePiece& line, float error) {
  const float across = 2 * (place.half_size[0] + place.half_size[1] + place.half_size[2]);
  const SlackTerms terms = SlackTerms::Of(place.longest_edge, error);
  const float side = line.way_length * (terms.side[0] * across + terms.side[1]);
  const Slack slack = {side, terms.range[0] * across + terms.range[1] + side};
  const Points start = AllPoints(line.start), way = AllPoints(line.way);
  uint32_t triangles = 0;
  for (int at = 0; at < place.count; at += Lanes::kWidth) {
    const Points corner = LoadPoints(block.corner[0], at);
    const Points edge_1 = LoadPoints(block.corner[1], at) - corner;
    const Points edge_2 = LoadPoints(block.corner[2], at) - corner;
    triangles |= MayMeet(start, way, corner, edge_1, edge_2, slack) << at;
  }
  return triangles & ((1u << place.count) - 1);
}

}  // namespace
}  // namespace eod::sim
