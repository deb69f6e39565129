#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Geometry>

#include "sim/segments/kernels.h"

namespace eod::sim {

/// The blocks round a robot. Gathered with a margin, so that the tree is asked again only when the
/// robot leaves it: between two steps it moves by millimetres.
class Surroundings {
 public:
  static constexpr double kMargin = 0.5;   ///< [m]
  static constexpr int kMaxBlocks = 4096;  ///< more are not listed: walk the tree instead
  static constexpr double kWidest = 16.0;  ///< [m] of what is asked for, without the margin

  /// A block of the list.
  struct Entry {
    int32_t block;
    float offset[3];  ///< [m] of its origin from the list's origin
    float error;      ///< [m] bound of the rounding of all coordinates in a test
  };

  /// Gathers what is near `box` (module's local frame). `revision` names the state of the tree.
  void Gather(const BlockTree& tree, const Kernels& kernels, const Eigen::AlignedBox3d& box,
              uint64_t revision);
  /// Whether the list is of this state of the tree.
  bool IsOf(uint64_t revision) const { return revision == revision_; }
  /// Whether it holds all that is near a packet, which is packed relative to `origin()`.
  bool Covers(const SegmentPacket& packet) const;
  /// Whether something near was asked for the time before too: a reader that stays is worth a list,
  /// a single question is not.
  bool IsWorthGathering(const Eigen::AlignedBox3d& box);
  /// False: too many blocks were near, the list is of no use.
  bool usable() const { return usable_; }

  const Eigen::Vector3d& origin() const { return origin_; }
  const BoxColumns& boxes() const { return boxes_; }
  const Entry& entry(int index) const { return entries_[static_cast<size_t>(index)]; }
  /// Room for the indices of all boxes.
  int32_t* found() { return found_.data(); }

 private:
  void Reserve();
  void CollectBlocks(const BlockTree& tree, const Kernels& kernels);
  void Describe(const BlockTree& tree);

  Eigen::AlignedBox3d region_, last_asked_;
  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
  uint64_t revision_ = 0;
  bool usable_ = false;
  std::vector<Entry> entries_;
  std::vector<float> columns_;  ///< six of kMaxBlocks
  std::vector<int32_t> found_;
  BoxColumns boxes_{};
  float half_size_[3] = {-1, -1, -1};  ///< [m] of the region, rounded down
};

}  // namespace eod::sim
