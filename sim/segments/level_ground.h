#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include <Eigen/Geometry>

#include "sim/geometry/object_class.h"
#include "sim/segments/block_tree.h"

namespace eod::sim {

/// Whether the triangles round a reader are one level plane: most of the ground that robots drive
/// on. Surveyed with a margin, and anew when the reader has left it.
class LevelGround {
 public:
  static constexpr double kMargin = 0.25;    ///< [m]
  static constexpr int kMostTriangles = 32;  ///< more are not looked at: not level

  /// Whether the last survey was of this state of the tree, of these classes, and round `box`.
  bool Covers(const Eigen::AlignedBox3d& box, uint32_t class_mask, uint64_t revision) const {
    return revision == revision_ && class_mask == class_mask_ && region_.contains(box);
  }

  /// Looks at all triangles near `box` (module's local frame) that `class_mask` accepts.
  void Survey(const BlockTree& tree, const Eigen::AlignedBox3d& box, uint32_t class_mask,
              uint64_t revision);

  /// Its height [m], exactly, if there is nothing but one level plane that looks up and reaches
  /// across the whole region: every vertical line there meets it, or ends before.
  std::optional<double> z() const { return z_; }

 private:
  using Corners = std::array<Eigen::Vector3d, 3>;

  bool Collect(const BlockTree& tree);
  bool Add(const BlockTree& tree, size_t block);
  bool IsUnderCentre() const;
  bool HasNoBorder() const;
  bool HasNeighbour(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const;
  bool IsCrossedBy(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const;

  Eigen::AlignedBox3d region_;
  uint32_t class_mask_ = 0;
  uint64_t revision_ = 0;
  std::optional<double> z_;
  std::array<Corners, kMostTriangles> triangles_;
  size_t count_ = 0;
};

}  // namespace eod::sim
