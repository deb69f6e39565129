#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "sim/geometry/mesh.h"
#include "sim/segments/segment.h"
#include "sim/world/world_model.h"

namespace eod::reference {

/// A segment made ready for many triangles: axes permuted and sheared so that it runs along +Z.
///
/// Watertight: along an edge or a corner that triangles share, at least one of them is met.
/// Source: Woop, Benthin, Wald, "Watertight Ray/Triangle Intersection", JCGT 2013, in double.
class PreparedSegment {
 public:
  PreparedSegment(const Eigen::Vector3d& start, const Eigen::Vector3d& direction, double length,
                  sim::FaceRule face_rule);

  /// Range at which the triangle is met, within [0, length]; nothing if it is missed or edge-on.
  std::optional<double> Meet(const sim::Triangle& triangle) const;

 private:
  Eigen::Vector3d start_;
  double length_;
  bool front_only_;
  int x_, y_, z_;  ///< permutation: z_ is the axis of the largest direction component
  double shear_x_, shear_y_, scale_z_;
};

struct Nearest {
  double range = 0;   ///< [m] from the start of the segment
  int triangle = -1;  ///< index in the list that was searched; -1: none
};

/// What every answer is judged by: all triangles against the segment. The triangle with the least
/// range, the lowest index among equals; hit rules are not looked at.
Nearest TryEveryTriangle(std::span<const sim::CollisionTriangle> triangles,
                         const sim::SegmentQuery& query);

/// Gives the answers of TryEveryTriangle by a bounding-volume tree, all in double: slow beside the
/// product's engine, simple enough to be read, and independent of it.
class DoubleTree {
 public:
  explicit DoubleTree(std::span<const sim::CollisionTriangle> triangles);

  Nearest Cast(const sim::SegmentQuery& query) const;

 private:
  struct Box {
    Eigen::Vector3d low, high;
  };
  /// Inner: children at first and first + 1. Leaf: `count` entries from first.
  struct Node {
    Box box;
    uint32_t classes = 0;  ///< union of what lies below: whole branches fall to the mask
    int first = 0;
    int count = 0;
  };
  struct Entry {
    sim::Triangle corner;
    uint32_t class_mask;
    int triangle;
  };
  struct Item;
  struct Split;
  struct Ray;

  void Build(int node, std::span<Item> items, int offset, int depth);
  static std::optional<Split> BestSplit(std::span<const Item> items);
  void TestLeaf(const Node& node, const PreparedSegment& segment, uint32_t class_mask,
                Nearest& nearest) const;

  std::vector<Node> nodes_;
  std::vector<Entry> entries_;
};

}  // namespace eod::reference
