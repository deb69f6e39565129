#include "sim/camera/street_textures.h"

#include <array>
#include <numbers>

#include "sim/camera/noise.h"
#include "sim/camera/paint_pattern.h"

namespace eod::sim {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

/// Render of a wall, before what hangs in it. Fine grain, streaks below.
float Render(float u, float v, uint32_t seed) {
  const float grain = LatticeValue(static_cast<int>(u * 256), static_cast<int>(v * 256), seed);
  const float streak = TilingNoise(u * 24, v * 4, 24, seed + 1);
  return 0.93F + 0.05F * (grain - 0.5F) - 0.05F * SmoothStep(0.45F, 1.0F, streak);
}

/// A window 1.2 m wide and 1.5 m high in a bay of 3 m; x, z [m] from the middle of its sill.
/// Nothing but `wall()` where there is no window.
template <typename Wall>
Colour WindowAt(float x, float z, int kind, const Wall& wall) {
  constexpr float kHalf = 0.60F, kHeight = 1.50F;
  const float across = std::abs(x);
  if (z < 0 && z > -0.10F && across < kHalf + 0.16F) return Grey(z > -0.03F ? 1.0F : 0.86F);
  if (z < -0.10F && z > -0.20F && across < kHalf + 0.16F)
    return wall() * 0.80F;  // shade of the sill
  if (z > -0.10F && z < kHeight + 0.14F && across < kHalf + 0.14F &&
      (across > kHalf || z > kHeight)) {
    return Grey(0.97F);  // surround
  }
  if (z < 0 || z > kHeight || across > kHalf) return wall();
  // The reveal lies in the shade of its upper and left edge.
  const float shade = z > kHeight - 0.10F || x < -kHalf + 0.07F ? 0.55F : 1.0F;
  const bool is_frame = across > kHalf - 0.09F || z < 0.08F || z > kHeight - 0.16F ||
                        across < 0.045F || std::abs(z - 1.02F) < 0.035F;
  if (is_frame) return Grey(0.95F * shade);
  const float sky = 0.20F + 0.16F * z / kHeight + (x + 0.4F * z > 0.35F ? 0.10F : 0.0F);
  const Colour glass(sky * 0.86F, sky * 0.98F, sky * 1.10F);
  const bool is_curtain = kind == 0   ? across > 0.30F - 0.10F * (z - 0.7F)
                          : kind == 1 ? z > 0.95F
                          : kind == 2 ? z < 0.55F
                                      : false;
  if (!is_curtain) return glass * shade;
  const float fold = 0.5F + 0.5F * std::sin(x * (kind == 1 ? 4.0F : 70.0F));
  return Grey((0.62F + 0.14F * fold) * shade);
}

}  // namespace

Canvas PaintGravel() {
  constexpr int kSide = 256;
  Canvas canvas(kSide, kSide);
  canvas.Fill([](float u, float v) {
    return Grey(0.44F + 0.14F * (TilingNoise(u * 90, v * 90, 90, 201) - 0.5F)).eval();
  });
  // Stones: an own tone each, light above, a dark joint round them.
  PaintRandom random(202);
  for (int stone = 0; stone < 1500; ++stone) {
    const Eigen::Vector2f at(random.Uniform(0, kSide), random.Uniform(0, kSide));
    const float radius = random.Uniform(1.8F, 5.2F), flat = random.Uniform(0.65F, 1.0F);
    const float tone = random.Uniform(0.46F, 0.82F), warm = random.Uniform(0.94F, 1.04F);
    const int reach = static_cast<int>(radius) + 1;
    for (int y = -reach; y <= reach; ++y) {
      for (int x = -reach; x <= reach; ++x) {
        const auto dx = static_cast<float>(x), dy = static_cast<float>(y) / flat;
        const float away = std::sqrt(dx * dx + dy * dy) / radius;
        if (away > 1.0F) continue;
        const float light = tone * (away > 0.82F ? 0.62F : 1.0F + 0.16F * dy / radius);
        canvas.At(static_cast<int>(at.x()) + x, static_cast<int>(at.y()) + y) =
            Colour(light * warm, light, light * (1.96F - warm));
      }
    }
  }
  return canvas;
}

Canvas PaintPaving() {
  constexpr int kSlabs = 3;
  Canvas canvas(256, 256);
  canvas.Fill([](float u, float v) {
    const Cell row = CellOf(v, kSlabs);
    const Cell column = CellOf(u + (row.index % 2 == 0 ? 0.0F : 0.5F / kSlabs), kSlabs);
    const float grain = TilingNoise(u * 128, v * 128, 128, 211);
    const float cloud = TilingNoise(u * 9, v * 9, 9, 212);
    float value = 0.72F + 0.12F * (LatticeValue(column.index % kSlabs, row.index, 213) - 0.5F);
    value += 0.09F * (grain - 0.5F) + 0.06F * (cloud - 0.5F);
    const float edge = std::min(EdgeDistance(row.place), EdgeDistance(column.place));
    value -= 0.30F * (1.0F - SmoothStep(0.012F, 0.032F, edge));
    return Colour(value, value * 0.985F, value * 0.95F);
  });
  return canvas;
}

Canvas PaintRender() {
  Canvas canvas(256, 256);
  canvas.Fill([](float u, float v) { return Grey(Render(u, v, 221)); });
  return canvas;
}

Canvas PaintRooftile() {
  constexpr int kCourses = 6, kTiles = 8;
  Canvas canvas(256, 256);
  canvas.Fill([](float u, float v) {
    const Cell course = CellOf(v, kCourses);
    const Cell tile = CellOf(u, kTiles);
    const float wave = 0.5F + 0.5F * std::cos(2 * kPi * tile.place);
    const float grain = TilingNoise(u * 96, v * 96, 96, 231);
    float value = 0.66F + 0.26F * wave * wave + 0.10F * (grain - 0.5F);
    value *= 0.90F + 0.16F * LatticeValue(tile.index, course.index, 232);
    // Each course throws its shade on the one below it.
    value *= 1.0F - 0.45F * SmoothStep(0.80F, 0.97F, course.place);
    return Colour(value, value * 0.97F, value * 0.93F);
  });
  return canvas;
}

Canvas PaintWindows() {
  constexpr float kSide = 6.0F, kBay = 3.0F, kSill = 0.85F;  // [m]
  Canvas canvas(512, 512);
  canvas.Fill([](float u, float v) {
    const Cell bay = CellOf(u, 2), storey = CellOf(v, 2);
    const auto wall = [u, v] { return Grey(Render(u, v, 241)); };
    const float x = (bay.place - 0.5F) * kSide / 2, z = storey.place * kBay - kSill;
    return WindowAt(x, z, (bay.index + 2 * storey.index + 1) % 4, wall);
  });
  return canvas;
}

Canvas PaintShopwindow() {
  constexpr int kBoards = 4, kGoods = 9;
  constexpr std::array<std::array<float, 3>, 6> kPaints{{{0.75F, 0.25F, 0.20F},
                                                         {0.85F, 0.70F, 0.25F},
                                                         {0.25F, 0.45F, 0.70F},
                                                         {0.80F, 0.78F, 0.72F},
                                                         {0.30F, 0.55F, 0.35F},
                                                         {0.55F, 0.38F, 0.26F}}};
  Canvas canvas(256, 256);
  canvas.Fill([&](float u, float v) {
    const Cell board = CellOf(v, kBoards);
    const Cell good = CellOf(u + 0.03F * static_cast<float>(board.index), kGoods);
    const int which = good.index % kGoods;
    const float tall = 0.35F + 0.45F * LatticeValue(which, board.index, 251);
    const float wide = 0.25F + 0.2F * LatticeValue(which, board.index, 252);
    Colour colour(0.17F, 0.15F, 0.13F);
    if (board.place < 0.07F) {
      colour = Colour(0.46F, 0.36F, 0.26F);
    } else if (board.place < tall && std::abs(good.place - 0.5F) < wide) {
      const auto& paint =
          kPaints.at(static_cast<size_t>(LatticeValue(which, board.index, 253) * 5.99F));
      const float round = 1.0F - 1.6F * std::abs(good.place - 0.45F);
      colour = Colour(paint[0], paint[1], paint[2]) * (0.45F + 0.45F * round);
    }
    // The street mirrors in the pane.
    const float glare = SmoothStep(0.45F, 0.55F, std::abs(std::sin(kPi * (u + v))));
    return Mix(colour, Colour(0.55F, 0.60F, 0.66F), 0.10F + 0.13F * (1.0F - glare));
  });
  return canvas;
}

Canvas PaintFruit() {
  constexpr int kRow = 6;
  Canvas canvas(128, 128);
  canvas.Fill([](float u, float v) {
    const Cell row = CellOf(v, kRow);
    const Cell column = CellOf(u + (row.index % 2 == 0 ? 0.0F : 0.5F / kRow), kRow);
    const float x = 2 * column.place - 1, y = 2 * row.place - 1;
    const float away = std::sqrt(x * x + y * y);
    const float tone = 0.84F + 0.16F * LatticeValue(column.index % kRow, row.index, 261);
    const float ball = std::sqrt(std::max(0.0F, 1.0F - away * away));
    const float shine = SmoothStep(0.35F, 0.0F, std::hypot(x + 0.3F, y - 0.35F)) * 0.2F;
    return Grey(away > 1.0F ? 0.16F : tone * (0.45F + 0.5F * ball) + shine).eval();
  });
  return canvas;
}

Canvas PaintLeaves() {
  constexpr int kSide = 256;
  Canvas canvas(kSide, kSide);
  canvas.Fill([](float u, float v) {
    return (Colour(0.16F, 0.24F, 0.11F) * (0.6F + 0.8F * TilingNoise(u * 12, v * 12, 12, 271)))
        .eval();
  });
  PaintRandom random(272);
  for (int leaf = 0; leaf < 4200; ++leaf) {
    const Eigen::Vector2f at(random.Uniform(0, kSide), random.Uniform(0, kSide));
    const float direction = random.Uniform(0, 2 * kPi), lightness = random.Uniform(0.55F, 1.2F);
    const Eigen::Vector2f way =
        Eigen::Vector2f(std::cos(direction), std::sin(direction)) * random.Uniform(2.5F, 5.0F);
    const Eigen::Vector2f side(-0.25F * way.y(), 0.25F * way.x());
    const Colour colour = Colour(0.36F, 0.52F, 0.22F) * lightness;
    canvas.Stroke(at, at + way, colour, 0.9F);
    canvas.Stroke(at + side, at + side + way * 0.7F, colour * 0.9F, 0.8F);
  }
  return canvas;
}

}  // namespace eod::sim
