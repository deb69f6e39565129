#include "sim/segments/block_packer.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace eod::sim {

using Eigen::Vector3d;

namespace {

float RoundedUp(double value) {
  return std::nextafter(static_cast<float>(value), std::numeric_limits<float>::infinity());
}

/// Pages that were never written to cost nothing; copying the others does.
template <typename Element>
void ShrinkIfMuchIsUnused(std::vector<Element>& list) {
  if (list.capacity() > list.size() + list.size() / 4) list.shrink_to_fit();
}

double LongestEdge(const Triangle& corner) {
  return std::sqrt(
      std::max({(corner[1] - corner[0]).squaredNorm(), (corner[2] - corner[1]).squaredNorm(),
                (corner[0] - corner[2]).squaredNorm()}));
}

}  // namespace

void BlockPacker::Reserve(size_t blocks) {
  tree_.blocks.reserve(blocks);
  tree_.places.reserve(blocks);
  tree_.triangles.reserve(blocks * kBlockSize);
  tree_.vertices.reserve(blocks * 14);
}

BlockPlace BlockPacker::PlaceOf(std::span<const Item> items) const {
  Vector3d low = Vector3d::Constant(std::numeric_limits<double>::infinity()), high = -low;
  double longest = 0;
  for (const Item& item : items) {
    const Triangle& corner = triangles_[item.index()].corner;
    for (const Vector3d& point : corner) {
      low = low.cwiseMin(point);
      high = high.cwiseMax(point);
    }
    longest = std::max(longest, LongestEdge(corner));
  }
  BlockPlace place;
  place.origin = ((low + high) / 2).cast<float>().cast<double>();
  const Vector3d half_size = (high - place.origin).cwiseMax(place.origin - low);
  for (int axis = 0; axis < 3; ++axis) place.half_size[axis] = RoundedUp(half_size[axis]);
  place.longest_edge = RoundedUp(longest);
  place.first_vertex = static_cast<uint32_t>(tree_.vertices.size());
  place.count = static_cast<int>(items.size());
  return place;
}

int32_t BlockPacker::Pack(std::span<const Item> items) {
  const auto index = static_cast<int32_t>(tree_.blocks.size());
  BlockPlace place = PlaceOf(items);
  Block& block = tree_.blocks.emplace_back();
  BlockVertices vertices(tree_.vertices);
  for (size_t i = 0; i < kBlockSize; ++i) {
    const Item& item = items[i < items.size() ? i : 0];
    const CollisionTriangle& triangle = triangles_[item.index()];
    ExactTriangle& exact = tree_.triangles.emplace_back();
    exact.triangle = static_cast<int32_t>(item.index());
    exact.surface = SurfaceIndex(triangle);
    place.classes |= triangle.class_mask;
    for (size_t corner = 0; corner < 3; ++corner) {
      exact.vertex[corner] = vertices.IndexOf(triangle.corner[corner]);
      const Vector3d local = triangle.corner[corner] - place.origin;
      for (int axis = 0; axis < 3; ++axis) {
        block.corner[corner][axis][i] = static_cast<float>(local[axis]);
        tree_.reach = std::max(tree_.reach, std::abs(triangle.corner[corner][axis]));
      }
    }
  }
  tree_.places.push_back(place);
  return index;
}

uint8_t BlockVertices::IndexOf(const Vector3d& corner) {
  // Odd factors spread coordinates that differ in few bits; the highest bits of the product depend
  // on all.
  const uint64_t bits = std::bit_cast<uint64_t>(corner.x()) * 0x9E3779B97F4A7C15u +
                        std::bit_cast<uint64_t>(corner.y()) * 0xC2B2AE3D27D4EB4Fu +
                        std::bit_cast<uint64_t>(corner.z()) * 0x165667B19E3779F9u;
  for (size_t slot = (bits * 0x9E3779B97F4A7C15u) >> 57;; slot = (slot + 1) % slots_.size()) {
    if (slots_[slot] == kFree) {
      slots_[slot] = static_cast<uint8_t>(vertices_.size() - first_);
      vertices_.push_back(corner);
      return slots_[slot];
    }
    const Vector3d& known = vertices_[first_ + slots_[slot]];
    if (known.x() == corner.x() && known.y() == corner.y() && known.z() == corner.z()) {
      return slots_[slot];
    }
  }
}

uint32_t BlockPacker::SurfaceIndex(const CollisionTriangle& triangle) {
  const Surface surface{triangle.class_mask, triangle.object};
  auto& surfaces = tree_.surfaces;
  if (!surfaces.empty() && surfaces[last_surface_] == surface) return last_surface_;
  const uint64_t key = uint64_t{triangle.class_mask} << 32 | static_cast<uint32_t>(triangle.object);
  const auto [found, is_new] = surface_index_.try_emplace(key, surfaces.size());
  if (is_new) surfaces.push_back(surface);
  return last_surface_ = found->second;
}

void BlockPacker::Finish() {
  ShrinkIfMuchIsUnused(tree_.nodes);
  ShrinkIfMuchIsUnused(tree_.blocks);
  ShrinkIfMuchIsUnused(tree_.places);
  ShrinkIfMuchIsUnused(tree_.triangles);
  ShrinkIfMuchIsUnused(tree_.vertices);
}

size_t BlockTree::Bytes() const {
  return nodes.size() * sizeof(Node) + blocks.size() * sizeof(Block) +
         places.size() * sizeof(BlockPlace) + triangles.size() * sizeof(ExactTriangle) +
         vertices.size() * sizeof(Vector3d) + surfaces.size() * sizeof(Surface);
}

}  // namespace eod::sim
