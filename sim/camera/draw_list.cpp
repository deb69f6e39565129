#include "sim/camera/draw_list.h"

#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "sim/camera/surface_textures.h"

namespace eod::sim {
namespace {

constexpr double kCell = 15.0;  // [m]
constexpr int kCellsOfBlock = 2, kBlocksOfRegion = 4;
constexpr double kLandscape = 300.0;  // [m] across
constexpr Detail kFineWorld{.chamfer = 0.02};
constexpr Detail kCoarseWorld{.max_segments = 10, .min_extent = 0.05};
// Three pixels where these are drawn.
constexpr Detail kBlockWorld{.max_segments = 8, .min_extent = 0.25, .cluster = 0.25};
constexpr Detail kRegionWorld{.max_segments = 6, .min_extent = 0.8, .cluster = 0.8};
constexpr Detail kFineThing{.chamfer = 0.006};
constexpr Detail kCoarseThing{.max_segments = 12, .min_extent = 0.05};

/// The same shapes twice.
struct Tessellation {
  SurfaceMesh fine;
  SurfaceMesh coarse;
};

IndexRun AppendMesh(const SurfaceMesh& mesh, DrawList& list) {
  const IndexRun run{static_cast<uint32_t>(list.mesh.indices.size()),
                     static_cast<uint32_t>(mesh.indices.size())};
  const auto base = static_cast<uint32_t>(list.mesh.vertices.size());
  list.mesh.vertices.insert(list.mesh.vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
  for (const uint32_t index : mesh.indices) list.mesh.indices.push_back(base + index);
  return run;
}

void AppendRange(const Tessellation& part, int texture, DrawList& list) {
  DrawRange range;
  range.texture = texture;
  for (const Vertex& vertex : part.fine.vertices) {
    range.bounds.extend(Eigen::Vector3f(vertex.position));
  }
  range.fine = AppendMesh(part.fine, list);
  range.coarse = AppendMesh(part.coarse, list);
  list.ranges.push_back(range);
}

/// By texture and bone, so that what has one texture stands together.
using Parts = std::map<std::pair<int, int>, Tessellation>;

DrawList ListOf(const Parts& parts) {
  DrawList list;
  for (const auto& [key, part] : parts) {
    AppendRange(part, key.first, list);
    list.ranges.back().bone = key.second;
  }
  return list;
}

/// Flat ground takes shadows but throws none; leaving it out saves filling the whole shadow map.
bool IsFlatGround(const DrawRange& range) { return range.bounds.max().z() < 0.03F; }

/// Hills and woods round a module throw no shadow: what is shaded is near.
bool CastsShadow(const Visual& visual) {
  return visual.casts_shadow && Extent(visual) < kLandscape;
}

int TextureOf(const Visual& visual, const std::filesystem::path& file) {
  try {
    return SurfaceTextureIndex(visual.material.texture);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(fmt::format("{}: {}", file.string(), error.what()));
  }
}

/// A square of the ground, counted in squares.
struct Square {
  int x = 0;
  int y = 0;
  auto operator<=>(const Square&) const = default;
  static Square At(const Eigen::Vector3d& p_M) {
    return {static_cast<int>(std::floor(p_M.x() / kCell)),
            static_cast<int>(std::floor(p_M.y() / kCell))};
  }
  /// The square of `side` times the size that this one lies in.
  Square Within(int side) const {
    const auto down = [side](int i) { return (i >= 0 ? i : i - side + 1) / side; };
    return {down(x), down(y)};
  }
};

/// Sorts visuals into cells, blocks and regions of the ground.
class WorldListBuilder {
 public:
  void Add(const Visual& visual, const Eigen::Isometry3d& X_MO, int texture) {
    const bool casts_shadow = CastsShadow(visual);
    if (visual.shape != Visual::Shape::kMesh || Extent(visual) <= kCell) {
      const Square square = Square::At(X_MO * visual.X_OV.translation());
      Append(visual, X_MO, texture, square, casts_shadow);
      return;
    }
    // A mesh as large as the terrain: each triangle where it lies.
    std::map<Square, Visual> pieces;
    const Eigen::Isometry3d X_MV = X_MO * visual.X_OV;
    for (size_t i = 0; i + 2 < visual.triangles.size(); i += 3) {
      const Eigen::Vector3f sum =
          visual.triangles[i] + visual.triangles[i + 1] + visual.triangles[i + 2];
      Visual& piece = pieces[Square::At(X_MV * (sum / 3).cast<double>())];
      piece.triangles.insert(piece.triangles.end(), visual.triangles.begin() + i,
                             visual.triangles.begin() + i + 3);
    }
    for (auto& [square, piece] : pieces) {
      piece.shape = visual.shape;
      piece.X_OV = visual.X_OV;
      piece.material = visual.material;
      Append(piece, X_MO, texture, square, casts_shadow);
    }
  }

  DrawList Build() const {
    DrawList list;
    for (const auto& [region_key, region] : regions_) {
      const size_t first_block = list.blocks.size();
      for (const auto& [block_key, block] : region.blocks) {
        const size_t first_range = list.ranges.size();
        for (const auto& [cell_key, part] : block.cells) {
          AppendRange(part, region_key.first, list);
          DrawRange& range = list.ranges.back();
          range.casts_shadow = cell_key.second && !IsFlatGround(range);
        }
        list.blocks.push_back(Bounded(block.mesh, list.ranges, first_range, list));
        list.blocks.back().texture = region_key.first;
      }
      list.regions.push_back(Bounded(region.mesh, list.blocks, first_block, list));
      list.regions.back().texture = region_key.first;
    }
    return list;
  }

 private:
  struct Block {
    SurfaceMesh mesh;
    std::map<std::pair<Square, bool>, Tessellation> cells;  ///< by place and whether it shades
  };
  struct Region {
    SurfaceMesh mesh;
    std::map<Square, Block> blocks;
  };

  void Append(const Visual& visual, const Eigen::Isometry3d& X_MO, int texture, Square cell,
              bool casts_shadow) {
    const Square block_square = cell.Within(kCellsOfBlock);
    Region& region = regions_[{texture, block_square.Within(kBlocksOfRegion)}];
    Block& block = region.blocks[block_square];
    Tessellation& part = block.cells[{cell, casts_shadow}];
    AppendVisual(visual, X_MO, 0, kFineWorld, part.fine);
    AppendVisual(visual, X_MO, 0, kCoarseWorld, part.coarse);
    AppendVisual(visual, X_MO, 0, kBlockWorld, block.mesh);
    AppendVisual(visual, X_MO, 0, kRegionWorld, region.mesh);
  }

  /// A block around parts[first] and all after it.
  template <typename Part>
  static DrawBlock Bounded(const SurfaceMesh& mesh, const std::vector<Part>& parts, size_t first,
                           DrawList& list) {
    DrawBlock block;
    block.first = first;
    block.count = parts.size() - first;
    for (size_t i = first; i < parts.size(); ++i) block.bounds.extend(parts[i].bounds);
    block.run = AppendMesh(mesh, list);
    return block;
  }

  std::map<std::pair<int, Square>, Region> regions_;  ///< by texture and place
};

}  // namespace

DrawList BuildWorldDrawList(const ModuleModel& module) {
  WorldListBuilder builder;
  for (const WorldObject& object : module.objects) {
    for (const Visual& visual : object.visuals) {
      builder.Add(visual, object.X_MO, TextureOf(visual, object.name));
    }
  }
  return builder.Build();
}

DrawList BuildMovablesDrawList(const ModuleModel& module) {
  const Eigen::Isometry3d X_OO = Eigen::Isometry3d::Identity();
  Parts parts;
  for (size_t i = 0; i < module.movables.size(); ++i) {
    for (const Visual& visual : module.movables[i].visuals) {
      const int bone = static_cast<int>(i);
      Tessellation& part = parts[{TextureOf(visual, module.movables[i].name), bone}];
      AppendVisual(visual, X_OO, bone, kFineThing, part.fine);
      AppendVisual(visual, X_OO, bone, kCoarseThing, part.coarse);
    }
  }
  return ListOf(parts);
}

DrawList BuildRobotDrawList(const RobotModel& robot) {
  const Eigen::Isometry3d X_LL = Eigen::Isometry3d::Identity();
  Parts parts;
  for (const LinkVisual& link_visual : robot.visuals) {
    const int bone = 1 + link_visual.link;
    Tessellation& part = parts[{TextureOf(link_visual.visual, robot.file), bone}];
    AppendVisual(link_visual.visual, X_LL, bone, kFineThing, part.fine);
    AppendVisual(link_visual.visual, X_LL, bone, kCoarseThing, part.coarse);
  }
  return ListOf(parts);
}

}  // namespace eod::sim
