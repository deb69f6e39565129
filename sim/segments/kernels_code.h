// The kernels' arithmetic, compiled once for each instruction set: included by kernels_*.cpp alone.
// Nothing but plain arrays in and out, so that no inline function of a library is compiled for a
// processor that may not be there.
#pragma once

#include "sim/segments/kernels.h"
#include "sim/segments/lanes.h"

namespace eod::sim {
namespace {

/// Unit roundoff of float times the operations of a triple product, and something to spare.
constexpr float kRounding = 16 * 6e-8F;

/// Bounds of the rounding errors in the segment-triangle test.
struct Slack {
  Lanes side;   ///< of u, v and the determinant
  Lanes range;  ///< of t and the determinant

  /// Ways up to `way` long, edges up to `edge`, starts up to `reach` from a corner, every
  /// coordinate difference wrong by up to `error` [m].
  Slack(float way, float edge, float reach, float error)
      : side(Lanes::All(way * SideOverWay(edge, reach, error))),
        range(Lanes::All(edge * (2 * reach + edge) * error + kRounding * edge * edge * reach +
                         way * SideOverWay(edge, reach, error))) {}

 private:
  static float SideOverWay(float edge, float reach, float error) {
    return (reach + 5 * edge) * error + kRounding * (reach + 2 * edge) * edge;
  }
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
  const Lanes least_side = slack.side ^ sign_bit, least_range = slack.range ^ sign_bit;
  return Bits((least_side <= u) & (least_side <= v) & (u + v <= size + slack.side) &
              (least_range <= t) & (t <= size + slack.range));
}

/// Boxes low..high that meet the box bottom..top.
inline Lanes Overlap(const Points& low, const Points& high, const Points& bottom,
                     const Points& top) {
  return (low.x <= top.x) & (bottom.x <= high.x) & (low.y <= top.y) & (bottom.y <= high.y) &
         (low.z <= top.z) & (bottom.z <= high.z);
}

/// Triangles of the block, from `at` on, whose boxes meet one of the pairs' boxes.
inline uint32_t BoxesMeet(const Block& block, int at, const SegmentPacket& packet,
                          const float* offset, float error) {
  const Points a = LoadPoints(block.corner[0], at), b = LoadPoints(block.corner[1], at),
               c = LoadPoints(block.corner[2], at), shift = AllPoints(offset);
  const Lanes slack = Lanes::All(error);
  const Points low = {Least(Least(a.x, b.x), c.x) + (shift.x - slack),
                      Least(Least(a.y, b.y), c.y) + (shift.y - slack),
                      Least(Least(a.z, b.z), c.z) + (shift.z - slack)};
  const Points high = {Largest(Largest(a.x, b.x), c.x) + (shift.x + slack),
                       Largest(Largest(a.y, b.y), c.y) + (shift.y + slack),
                       Largest(Largest(a.z, b.z), c.z) + (shift.z + slack)};
  uint32_t bits = 0;
  for (int pair = 0; pair < packet.pairs; ++pair) {
    bits |= Bits(
        Overlap(low, high, AllPoints(packet.pair_low[pair]), AllPoints(packet.pair_high[pair])));
  }
  return bits;
}

inline Points CornerOf(const Block& block, int corner, uint32_t triangle) {
  return {Lanes::All(block.corner[corner][0][triangle]),
          Lanes::All(block.corner[corner][1][triangle]),
          Lanes::All(block.corner[corner][2][triangle])};
}

inline uint32_t UsedPlaces(const BlockPlace& place) { return (1u << place.count) - 1; }

int OverlappingBoxes(const BoxColumns& boxes, const SegmentPacket& packet, int32_t* found) {
  const Points bottom = AllPoints(packet.low), top = AllPoints(packet.high);
  int count = 0;
  for (int at = 0; at < boxes.count; at += Lanes::kWidth) {
    const Points low = {Lanes::Load(boxes.low[0] + at), Lanes::Load(boxes.low[1] + at),
                        Lanes::Load(boxes.low[2] + at)};
    const Points high = {Lanes::Load(boxes.high[0] + at), Lanes::Load(boxes.high[1] + at),
                         Lanes::Load(boxes.high[2] + at)};
    if (Bits(Overlap(low, high, bottom, top)) == 0) continue;
    uint32_t bits = 0;
    for (int pair = 0; pair < packet.pairs; ++pair) {
      bits |= Bits(
          Overlap(low, high, AllPoints(packet.pair_low[pair]), AllPoints(packet.pair_high[pair])));
    }
    for (; bits != 0; bits &= bits - 1) found[count++] = at + __builtin_ctz(bits);
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

int TestPacket(const Block& block, const BlockPlace& place, const SegmentPacket& packet,
               const float* offset, float error, Candidate* found, uint64_t& tested) {
  uint32_t triangles = 0;
  for (int at = 0; at < place.count; at += Lanes::kWidth) {
    triangles |= BoxesMeet(block, at, packet, offset, error) << at;
  }
  triangles &= UsedPlaces(place);
  if (triangles == 0) return 0;

  const Slack slack(packet.longest, place.longest_edge,
                    packet.diagonal + place.longest_edge + 2 * error, error);
  tested += static_cast<uint64_t>(__builtin_popcount(triangles)) *
            static_cast<uint64_t>(__builtin_popcount(packet.lanes));
  const Points shift = AllPoints(offset);
  constexpr int kParts = 8 / Lanes::kWidth;
  Points start[kParts], way[kParts];
  int parts = 0;
  for (; parts < kParts && (packet.lanes >> (parts * Lanes::kWidth)) != 0; ++parts) {
    start[parts] = LoadPoints(packet.start, parts * Lanes::kWidth) - shift;
    way[parts] = LoadPoints(packet.way, parts * Lanes::kWidth);
  }
  int count = 0;
  for (; triangles != 0; triangles &= triangles - 1) {
    const auto triangle = static_cast<uint32_t>(__builtin_ctz(triangles));
    const Points corner = CornerOf(block, 0, triangle);
    const Points edge_1 = CornerOf(block, 1, triangle) - corner;
    const Points edge_2 = CornerOf(block, 2, triangle) - corner;
    uint32_t lanes = 0;
    for (int part = 0; part < parts; ++part) {
      lanes |= MayMeet(start[part], way[part], corner, edge_1, edge_2, slack)
               << (part * Lanes::kWidth);
    }
    lanes &= packet.lanes;
    if (lanes == 0) continue;
    found[count++] = {static_cast<uint8_t>(triangle), static_cast<uint8_t>(lanes)};
  }
  return count;
}

uint32_t TestLine(const Block& block, const BlockPlace& place, const LinePiece& line, float error) {
  const float across = 2 * (place.half_size[0] + place.half_size[1] + place.half_size[2]);
  const Slack slack(line.way_length, place.longest_edge, across + 2 * error, error);
  const Points start = AllPoints(line.start), way = AllPoints(line.way);
  uint32_t triangles = 0;
  for (int at = 0; at < place.count; at += Lanes::kWidth) {
    const Points corner = LoadPoints(block.corner[0], at);
    const Points edge_1 = LoadPoints(block.corner[1], at) - corner;
    const Points edge_2 = LoadPoints(block.corner[2], at) - corner;
    triangles |= MayMeet(start, way, corner, edge_1, edge_2, slack) << at;
  }
  return triangles & UsedPlaces(place);
}

}  // namespace
}  // namespace eod::sim
