#pragma once

#include <cstdint>
#include <span>
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

  /// Takes the half megabyte that lists need; otherwise the first gathering does.
  void Reserve();

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
  /// The boxes of one class mask.
  struct ClassBoxes {
    uint32_t classes;
    BoxColumns boxes;
  };
  std::span<const ClassBoxes> classes() const { return classes_; }
  /// One a box, by its number.
  const NearBlock* blocks() const { return entries_.data(); }
  /// Room for all boxes twice, and for what comes of them.
  NearBox* found() { return found_.data(); }
  PacketWork& work() { return work_[0]; }

 private:
  void CollectBlocks(const BlockTree& tree, const Kernels& kernels);
  void ListByClass(const BlockTree& tree);
  void Append(const BlockTree& tree, int32_t block);
  void PadToEight();

  Eigen::AlignedBox3d region_, last_asked_;
  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
  uint64_t revision_ = 0;
  bool usable_ = false;
  std::vector<NearBlock> entries_;
  std::vector<float> columns_;  ///< six of kMaxBlocks
  std::vector<NearBox> found_;
  std::vector<PacketWork> work_;  ///< one
  std::vector<int32_t> collected_;
  std::vector<ClassBoxes> classes_;
  float half_size_[3] = {-1, -1, -1};  ///< [m] of the region, rounded down
};

}  // namespace eod::sim
