#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "sim/geometry/mesh.h"
#include "sim/world/segment_triangle.h"
#include "sim/world/world_model.h"

namespace eod::sim {

/// Bounding-volume tree over triangles that stand still, in double. Built once by binned
/// surface-area heuristic; the same triangles always give the same tree.
class TriangleTree {
 public:
  struct Nearest {
    double range = 0;
    int triangle = -1;  ///< index in the list the tree was built from; -1: none
  };

  explicit TriangleTree(std::span<const CollisionTriangle> triangles);

  /// The triangle with the least range, the lowest index among equals. `candidates` counts the
  /// triangles that were offered to the exact test.
  Nearest Cast(const Eigen::Vector3d& start, const Eigen::Vector3d& direction, double length,
               uint32_t class_mask, FaceRule face_rule, uint64_t& candidates) const;

  size_t node_count() const { return nodes_.size(); }

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
    Triangle corner;
    uint32_t class_mask;
    int triangle;
  };
  struct Item;
  struct Split;
  struct Ray;

  void Build(int node, std::span<Item> items, int offset, int depth);
  static std::optional<Split> BestSplit(std::span<const Item> items);
  void TestLeaf(const Node& node, const PreparedSegment& segment, uint32_t class_mask,
                Nearest& nearest, uint64_t& candidates) const;

  std::vector<Node> nodes_;
  std::vector<Entry> entries_;
};

}  // namespace eod::sim
