#pragma once

#include <array>
#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "sim/segments/cast_memory.h"
#include "sim/segments/shape.h"

namespace eod::sim {

/// The objects of a module that move: exact shapes, each tested in its own pose. An object may have
/// several.
class MovableShapes {
 public:
  /// `object` at X_MO gets `shape` at X_OS. Poses are rigid (rotations orthonormal to 1e-12).
  void Add(int object, uint32_t class_mask, Shape shape, const Eigen::Isometry3d& X_MO,
           const Eigen::Isometry3d& X_OS = Eigen::Isometry3d::Identity());
  /// All shapes of `object`; false if it has none. None of these may run while others cast.
  bool Move(int object, const Eigen::Isometry3d& X_MO);
  /// Until it is moved again.
  bool Hide(int object);
  bool Remove(int object);

  /// Whether a shape that `class_mask` accepts may be within `box`.
  bool IsNear(const Eigen::AlignedBox3d& box, uint32_t class_mask) const;

  size_t size() const { return placed_.size(); }

  /// Merges what `queries[i]` meets into `hits[i]`, as other casts have left it: there stays what
  /// `IsPreferred` says. Appends to `memory.all` for queries that want all and brings it into
  /// order. Counts candidates, no more. Queries that are not castable are left alone.
  /// Thread-safe for reading, with one `memory` a thread; no allocation once that has grown.
  void Cast(std::span<const SegmentQuery> queries, std::span<SegmentHit> hits,
            CastMemory& memory) const;

 private:
  struct Placed {
    int object;
    uint32_t class_mask;
    Shape shape;
    Eigen::Isometry3d X_OS, X_MS;
    bool hidden = false;
  };

  /// Bounds of all shapes, corner by corner: a group of queries is culled against a batch of them
  /// without a branch. Padded to whole batches with boxes that nothing meets.
  static constexpr size_t kBatch = 32;
  struct BoxList {
    std::array<std::vector<double>, 3> low, high;
    void Resize(size_t count);
    void Set(size_t index, const Eigen::AlignedBox3d& box);
    bool Overlaps(size_t index, const Eigen::AlignedBox3d& box) const;
    /// Bit i: box `first` + i overlaps.
    uint32_t OverlappingBatch(size_t first, const Eigen::AlignedBox3d& box) const;
  };

  /// The shapes near all queries of a cast together, if they are few: mostly there are none.
  struct NearShapes {
    static constexpr size_t kMost = 4;
    std::array<size_t, kMost> index{};
    size_t count = 0;
    bool are_few = true;
  };

  void Place(size_t index, const Eigen::Isometry3d& X_MO);
  NearShapes ShapesNear(std::span<const SegmentQuery> queries) const;
  /// A run of queries, beginning at `first` in the list, against the near shapes, or all.
  void CastGroup(std::span<const SegmentQuery> group, size_t first, const NearShapes& near,
                 std::span<SegmentHit> hits, CastMemory& memory) const;
  void CastAt(size_t shape, std::span<const SegmentQuery> group, size_t first,
              std::span<SegmentHit> hits, CastMemory& memory) const;
  static void Meet(const Placed& placed, size_t index, const SegmentQuery& query, SegmentHit& best,
                   CastMemory& memory);

  std::vector<Placed> placed_;
  BoxList bounds_;
};

}  // namespace eod::sim
