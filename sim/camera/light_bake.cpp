#include "sim/camera/light_bake.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

namespace eod::sim {
namespace {

using Eigen::Vector3f;

constexpr float kFinest = 2.4F;    // [m] longest edge under a roof
constexpr float kBlockFinest = 6;  // the same of blocks, which are far away
constexpr float kUncut = 1e6F;
constexpr float kLongest = 60;       // [m] an edge of what may be cut: hills around are left whole
constexpr size_t kMostGrowth = 12;   // times the triangles of a mesh, and ...
constexpr size_t kMostAdded = 6000;  // ... some: what is worth its triangles
constexpr float kLampShare = 0.35F;  // longest edge near a lamp, of the distance to it
constexpr double kDimLamp = 0.02;    // light that needs no finer mesh
constexpr int kFills = 3;            // rounds of filling what lies within walls

Vector3f PositionOf(const Vertex& vertex) { return Vector3f(vertex.position); }

Vector3f NormalOf(const Vertex& vertex) {
  return Vector3f(vertex.normal[0], vertex.normal[1], vertex.normal[2]) / 32767.0F;
}

template <typename Number>
Number Middle(Number a, Number b) {
  return static_cast<Number>((a + b) / 2);
}

Vertex MiddleOf(const Vertex& a, const Vertex& b) {
  Vertex middle = a;
  const Vector3f normal = (NormalOf(a) + NormalOf(b)).normalized();
  for (int axis = 0; axis < 3; ++axis) {
    middle.position[axis] = Middle(a.position[axis], b.position[axis]);
    middle.normal[axis] = static_cast<int16_t>(std::lround(normal[axis] * 32767.0F));
    middle.diffuse[axis] = Middle(a.diffuse[axis], b.diffuse[axis]);
    middle.lamps[axis] = Middle(a.lamps[axis], b.lamps[axis]);
  }
  for (int axis = 0; axis < 2; ++axis) middle.uv[axis] = Middle(a.uv[axis], b.uv[axis]);
  return middle;
}

/// A lamp near a mesh, and how far it matters.
struct NearLamp {
  Vector3f p_M;
  float reach;
};

float ReachOf(const Lamp& lamp) {
  double reach = lamp.light.falloff.range;
  const auto brightness = static_cast<double>(lamp.light.colour.maxCoeff());
  while (reach > 0.5 && lamp.light.falloff.At(reach) * brightness < kDimLamp) reach *= 0.9;
  return static_cast<float>(reach);
}

/// Splits a mesh until no edge is longer than it may be.
class Refiner {
 public:
  Refiner(LightProbe& probe, float finest, SurfaceMesh& mesh)
      : probe_(probe), finest_(finest), mesh_(mesh) {
    Eigen::AlignedBox3f bounds;
    for (const Vertex& vertex : mesh.vertices) bounds.extend(PositionOf(vertex));
    for (const Lamp& lamp : probe.lamps()) {
      const NearLamp near{lamp.p_M.cast<float>(), ReachOf(lamp)};
      if (bounds.exteriorDistance(near.p_M) < near.reach) lamps_.push_back(near);
    }
  }

  void Run() {
    std::vector<uint32_t> whole;
    std::swap(whole, mesh_.indices);
    const size_t most = kMostGrowth * whole.size() + 3 * kMostAdded;
    // Last in, first out: a queue of triangles that still have to be looked at.
    std::vector<std::array<uint32_t, 3>> queue;
    for (size_t i = 0; i + 2 < whole.size(); i += 3) {
      queue.push_back({whole[i], whole[i + 1], whole[i + 2]});
      while (!queue.empty()) {
        const std::array<uint32_t, 3> triangle = queue.back();
        queue.pop_back();
        const bool is_full = mesh_.indices.size() > most || IsLandscape(triangle);
        const int edge = is_full ? -1 : EdgeToSplit(triangle);
        if (edge < 0) {
          mesh_.indices.insert(mesh_.indices.end(), triangle.begin(), triangle.end());
          continue;
        }
        const uint32_t a = triangle[static_cast<size_t>(edge)];
        const uint32_t b = triangle[static_cast<size_t>((edge + 1) % 3)];
        const uint32_t c = triangle[static_cast<size_t>((edge + 2) % 3)];
        const uint32_t middle = MiddleVertex(a, b);
        queue.push_back({a, middle, c});
        queue.push_back({middle, b, c});
      }
    }
  }

 private:
  bool IsLandscape(const std::array<uint32_t, 3>& triangle) const {
    Eigen::AlignedBox3f box;
    for (const uint32_t corner : triangle) box.extend(PositionOf(mesh_.vertices[corner]));
    return box.diagonal().norm() > kLongest;
  }

  /// The longest of those that are too long, -1 if none is.
  int EdgeToSplit(const std::array<uint32_t, 3>& triangle) {
    int longest = -1;
    float length = 0;
    for (int edge = 0; edge < 3; ++edge) {
      const uint32_t a = triangle[static_cast<size_t>(edge)];
      const uint32_t b = triangle[static_cast<size_t>((edge + 1) % 3)];
      const float now =
          (PositionOf(mesh_.vertices[a]) - PositionOf(mesh_.vertices[b])).squaredNorm();
      if (now > length && IsTooLong(a, b, now)) {
        longest = edge;
        length = now;
      }
    }
    return longest;
  }

  bool IsTooLong(uint32_t index_a, uint32_t index_b, float squared_length) {
    if (squared_length <= finest_ * finest_) return false;
    const Vector3f a = PositionOf(mesh_.vertices[index_a]);
    const Vector3f b = PositionOf(mesh_.vertices[index_b]);
    for (const NearLamp& lamp : lamps_) {
      const float along = std::clamp((lamp.p_M - a).dot(b - a) / squared_length, 0.0F, 1.0F);
      const float distance = (a + along * (b - a) - lamp.p_M).norm();
      const float limit = kLampShare * distance;
      if (distance < lamp.reach && squared_length > limit * limit) return true;
    }
    const Vector3f normal = NormalOf(mesh_.vertices[index_a]) + NormalOf(mesh_.vertices[index_b]);
    return IsRoofed(index_a) || IsRoofed(index_b) ||
           probe_.IsRoofed((a + b) / 2, normal.normalized());
  }

  bool IsRoofed(uint32_t index) {
    if (roofed_.size() < mesh_.vertices.size()) roofed_.resize(mesh_.vertices.size(), kUnknown);
    if (roofed_[index] == kUnknown) {
      const Vertex& vertex = mesh_.vertices[index];
      const bool is_roofed = probe_.IsRoofed(PositionOf(vertex), NormalOf(vertex));
      roofed_[index] = is_roofed ? kRoofed : kOpen;
    }
    return roofed_[index] == kRoofed;
  }

  uint32_t MiddleVertex(uint32_t a, uint32_t b) {
    const uint64_t key = static_cast<uint64_t>(std::min(a, b)) << 32U | std::max(a, b);
    const auto [place, is_new] =
        middles_.try_emplace(key, static_cast<uint32_t>(mesh_.vertices.size()));
    if (is_new) mesh_.vertices.push_back(MiddleOf(mesh_.vertices[a], mesh_.vertices[b]));
    return place->second;
  }

  static constexpr uint8_t kUnknown = 0, kOpen = 1, kRoofed = 2;
  LightProbe& probe_;
  const float finest_;
  SurfaceMesh& mesh_;
  std::vector<NearLamp> lamps_;
  std::vector<uint8_t> roofed_;  // by vertex
  std::unordered_map<uint64_t, uint32_t> middles_;
};

/// Gives vertices within walls the mean of their neighbours: light must not dip where a floor runs
/// on under a wall.
void Fill(const SurfaceMesh& mesh, std::vector<bool> is_known, std::vector<PlaceLight>& lights) {
  for (int round = 0; round < kFills; ++round) {
    std::unordered_map<uint32_t, std::pair<PlaceLight, int>> sums;
    for (size_t i = 0; i < mesh.indices.size(); ++i) {
      const uint32_t at = mesh.indices[i];
      if (is_known[at]) continue;
      auto& [sum, count] = sums.try_emplace(at, PlaceLight{.sky = 0}, 0).first->second;
      for (const uint32_t other :
           {mesh.indices[i - i % 3], mesh.indices[i - i % 3 + 1], mesh.indices[i - i % 3 + 2]}) {
        if (!is_known[other]) continue;
        sum.lamps += lights[other].lamps;
        sum.sky += lights[other].sky;
        ++count;
      }
    }
    for (const auto& [at, sum] : sums) {
      if (sum.second == 0) continue;
      const auto count = static_cast<float>(sum.second);
      lights[at] = {.lamps = sum.first.lamps / count, .sky = sum.first.sky / count};
      is_known[at] = true;
    }
  }
}

void Write(const PlaceLight& light, Vertex& vertex) {
  for (int channel = 0; channel < 3; ++channel) {
    const float own = static_cast<float>(vertex.lamps[channel]) / 255.0F;
    const float root = std::sqrt(light.lamps[channel] / kBrightest + own * own);
    vertex.lamps[channel] = static_cast<uint8_t>(std::lround(std::min(root, 1.0F) * 255.0F));
  }
  vertex.sky = static_cast<uint8_t>(std::lround(std::clamp(light.sky, 0.0F, 1.0F) * 255.0F));
}

void Bake(LightProbe& probe, float finest, SurfaceMesh& mesh) {
  Refiner(probe, finest, mesh).Run();
  std::vector<PlaceLight> lights(mesh.vertices.size());
  std::vector<bool> is_known(mesh.vertices.size(), true);
  bool is_all_known = true;
  for (size_t i = 0; i < mesh.vertices.size(); ++i) {
    const Vector3f place = PositionOf(mesh.vertices[i]);
    const Vector3f normal = NormalOf(mesh.vertices[i]);
    lights[i] = probe.At(place, normal);
    if (lights[i].sky < 1 && probe.IsInside(place, normal)) {
      is_known[i] = false;
      is_all_known = false;
    }
  }
  if (!is_all_known) Fill(mesh, is_known, lights);
  for (size_t i = 0; i < mesh.vertices.size(); ++i) Write(lights[i], mesh.vertices[i]);
}

/// The triangles of a run, as a mesh of their own.
SurfaceMesh MeshOf(const SurfaceMesh& mesh, const IndexRun& run) {
  SurfaceMesh part;
  if (run.count == 0) return part;
  const auto begin = mesh.indices.begin() + run.first;
  const auto [lowest, highest] = std::minmax_element(begin, begin + run.count);
  const uint32_t base = *lowest;
  part.vertices.assign(mesh.vertices.begin() + base, mesh.vertices.begin() + *highest + 1);
  for (uint32_t i = 0; i < run.count; ++i) part.indices.push_back(begin[i] - base);
  return part;
}

}  // namespace

void BakeLight(LightProbe& probe, DrawList& list) {
  SurfaceMesh baked;
  const auto bake = [&](float finest, IndexRun& run) {
    SurfaceMesh part = MeshOf(list.mesh, run);
    Bake(probe, finest, part);
    const auto base = static_cast<uint32_t>(baked.vertices.size());
    run = {.first = static_cast<uint32_t>(baked.indices.size()),
           .count = static_cast<uint32_t>(part.indices.size())};
    baked.vertices.insert(baked.vertices.end(), part.vertices.begin(), part.vertices.end());
    for (const uint32_t index : part.indices) baked.indices.push_back(base + index);
  };
  for (DrawRange& range : list.ranges) {
    bake(kFinest, range.fine);
    bake(2 * kFinest, range.coarse);
  }
  for (DrawBlock& block : list.blocks) bake(kBlockFinest, block.run);
  for (DrawBlock& region : list.regions) bake(kUncut, region.run);
  list.mesh = std::move(baked);
}

}  // namespace eod::sim
