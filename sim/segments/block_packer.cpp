#include "sim/segments/block_packer.h"

#include <algorithm>
#include <cmath>

namespace eod::sim {

using Eigen::Vector3d;

namespace {

float RoundedUp(double value) {
  return std::nextafter(static_cast<float>(value), std::numeric_limits<float>::infinity());
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
  for (size_t i = 0; i < kBlockSize; ++i) {
    const Item& item = items[i < items.size() ? i : 0];
    const CollisionTriangle& triangle = triangles_[item.index()];
    ExactTriangle& exact = tree_.triangles.emplace_back();
    exact.triangle = static_cast<int32_t>(item.index());
    exact.surface = SurfaceIndex(triangle);
    place.classes |= triangle.class_mask;
    for (size_t corner = 0; corner < 3; ++corner) {
      exact.vertex[corner] = VertexIndex(place.first_vertex, triangle.corner[corner]);
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

uint8_t BlockPacker::VertexIndex(uint32_t first_vertex, const Vector3d& corner) {
  auto& vertices = tree_.vertices;
  // Neighbours come one after the other: the last corners are the likely ones.
  for (size_t i = vertices.size(); i > first_vertex; --i) {
    const Vector3d& known = vertices[i - 1];
    if (known.x() == corner.x() && known.y() == corner.y() && known.z() == corner.z()) {
      return static_cast<uint8_t>(i - 1 - first_vertex);
    }
  }
  vertices.push_back(corner);
  return static_cast<uint8_t>(vertices.size() - 1 - first_vertex);
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
  tree_.nodes.shrink_to_fit();
  tree_.blocks.shrink_to_fit();
  tree_.places.shrink_to_fit();
  tree_.triangles.shrink_to_fit();
  tree_.vertices.shrink_to_fit();
}

size_t BlockTree::Bytes() const {
  return nodes.capacity() * sizeof(Node) + blocks.capacity() * sizeof(Block) +
         places.capacity() * sizeof(BlockPlace) + triangles.capacity() * sizeof(ExactTriangle) +
         vertices.capacity() * sizeof(Vector3d) + surfaces.capacity() * sizeof(Surface);
}

}  // namespace eod::sim
