#include "sim/camera/surface_textures.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "sim/camera/interior_textures.h"
#include "sim/camera/noise.h"
#include "sim/camera/paint_pattern.h"
#include "sim/camera/street_textures.h"

namespace eod::sim {
namespace {

/// Thin dark wandering lines: where a noise crosses its middle.
float Crack(float u, float v, int period, float width, uint32_t seed) {
  const float scale = static_cast<float>(period);
  const float level = TilingFbm(u * scale, v * scale, period, 5, seed) - 0.5F;
  const float sparse =
      TilingNoise(u * scale * 0.5F, v * scale * 0.5F, std::max(1, period / 2), seed + 7);
  return (1.0F - SmoothStep(0.0F, width, std::abs(level))) * SmoothStep(0.5F, 0.75F, sparse);
}

Canvas PaintPlain() {
  Canvas canvas(128, 128);
  canvas.Fill(
      [](float u, float v) { return Grey(0.93F + 0.07F * TilingFbm(u * 8, v * 8, 8, 4, 11)); });
  return canvas;
}

Canvas PaintGrass() {
  constexpr int kSide = 512;
  Canvas canvas(kSide, kSide);
  const Colour soil(0.36F, 0.33F, 0.22F);
  const Colour moss(0.33F, 0.42F, 0.20F);
  canvas.Fill([&](float u, float v) {
    const float patch = TilingFbm(u * 6, v * 6, 6, 5, 21);
    return Mix(soil, moss, SmoothStep(0.35F, 0.6F, patch)).eval();
  });
  // Blades: short strokes, darker at the root, a few of them dry.
  PaintRandom random(2024);
  for (int blade = 0; blade < 30000; ++blade) {
    const Eigen::Vector2f root(random.Uniform(0, kSide), random.Uniform(0, kSide));
    const float direction = random.Uniform(0, 2 * std::numbers::pi_v<float>);
    const float length = random.Uniform(4, 13);
    const float lightness = random.Uniform(0.75F, 1.18F);
    Colour colour = Colour(0.39F, 0.52F, 0.23F) * lightness;
    if (random.Uniform(0, 1) < 0.13F) colour = Colour(0.60F, 0.57F, 0.36F) * lightness;
    if (random.Uniform(0, 1) < 0.22F) colour = Colour(0.29F, 0.43F, 0.19F) * lightness;
    const Eigen::Vector2f way(std::cos(direction), std::sin(direction));
    canvas.Stroke(root, root + way * (length * 0.4F), colour * 0.8F, 0.7F);
    canvas.Stroke(root + way * (length * 0.4F), root + way * length, colour, 0.8F);
  }
  return canvas;
}

Canvas PaintConcrete() {
  Canvas canvas(512, 512);
  canvas.Fill([](float u, float v) {
    const float cloud = TilingFbm(u * 4, v * 4, 4, 6, 31);
    const float grain = TilingNoise(u * 256, v * 256, 256, 32);
    const float pore = SmoothStep(0.86F, 0.95F, TilingNoise(u * 96, v * 96, 96, 33));
    const float stain = SmoothStep(0.55F, 0.8F, TilingFbm(u * 3, v * 3, 3, 4, 34));
    float value = 0.70F + 0.14F * (cloud - 0.5F) + 0.07F * (grain - 0.5F);
    value -= 0.10F * pore + 0.07F * stain + 0.16F * Crack(u, v, 4, 0.006F, 35);
    // Joint of the formwork at the tile's edge: a dark gap with a lighter rim.
    const float edge = std::min(EdgeDistance(u), EdgeDistance(v));
    value -= 0.28F * (1.0F - SmoothStep(0.003F, 0.007F, edge));
    value += 0.04F * (SmoothStep(0.006F, 0.010F, edge) - SmoothStep(0.012F, 0.03F, edge));
    return Colour(value * 1.01F, value, value * 0.965F);
  });
  return canvas;
}

Canvas PaintBrick() {
  constexpr int kRows = 12;
  constexpr int kColumns = 4;
  Canvas canvas(512, 512);
  canvas.Fill([](float u, float v) {
    const Cell row = CellOf(v, kRows);
    const Cell column = CellOf(u + (row.index % 2 == 0 ? 0.0F : 0.5F / kColumns), kColumns);
    const int brick = column.index % kColumns;
    const float grain = TilingFbm(u * 64, v * 64, 64, 3, 41);
    const float rough = 0.010F * TilingFbm(u * 48, v * 48, 48, 2, 42);
    // Distances to the brick's edge in shares of a tile, so that joints are equally wide.
    const float edge =
        std::min(EdgeDistance(row.place) / kRows, EdgeDistance(column.place) / kColumns);
    const float mortar = 1.0F - SmoothStep(0.003F, 0.007F, edge - 0.004F + rough);
    const float hue = LatticeValue(brick, row.index, 43);
    const float tone = LatticeValue(brick, row.index, 44);
    Colour face = Mix(Colour(0.63F, 0.35F, 0.27F), Colour(0.72F, 0.47F, 0.36F), hue);
    if (tone > 0.86F) face = Colour(0.47F, 0.30F, 0.27F);
    face *= 0.86F + 0.14F * tone + 0.22F * (grain - 0.5F);
    // Upper edge catches light, lower edge lies in its own shade.
    face *= 1.0F + 0.10F * SmoothStep(0.80F, 0.93F, row.place) -
            0.16F * (1.0F - SmoothStep(0.07F, 0.18F, row.place));
    const Colour joint = Grey(0.60F + 0.12F * (grain - 0.5F));
    return Mix(face, joint, mortar).eval();
  });
  return canvas;
}

Canvas PaintAsphalt() {
  Canvas canvas(512, 512);
  canvas.Fill([](float u, float v) {
    const float cloud = TilingFbm(u * 5, v * 5, 5, 4, 51);
    const float grit = TilingNoise(u * 170, v * 170, 170, 52);
    const float stone = SmoothStep(0.80F, 0.95F, TilingNoise(u * 120, v * 120, 120, 53));
    float value = 0.43F + 0.08F * (cloud - 0.5F) + 0.12F * (grit - 0.5F) + 0.13F * stone;
    value -= 0.15F * Crack(u, v, 3, 0.007F, 54);
    return Colour(value, value, value * 1.02F);
  });
  return canvas;
}

Canvas PaintWood() {
  constexpr int kBoards = 4;
  Canvas canvas(256, 256);
  canvas.Fill([](float u, float v) {
    const Cell board = CellOf(v, kBoards);
    const float shift = LatticeValue(board.index, 0, 61);
    const float wave = TilingFbm(u * 3 + shift * 3, v * 12, 12, 3, 62);
    const float ring = 0.5F + 0.5F * std::sin((v * 40.0F + wave * 9.0F + shift * 6.0F) * 4.0F);
    const float fibre = TilingNoise(u * 16, v * 128, 128, 63);
    const float tone = 0.88F + 0.2F * LatticeValue(board.index, 1, 64);
    Colour colour = Mix(Colour(0.66F, 0.50F, 0.33F), Colour(0.76F, 0.61F, 0.43F), ring * 0.6F);
    colour *= tone * (0.93F + 0.14F * fibre);
    const float gap = 1.0F - SmoothStep(0.015F, 0.045F, EdgeDistance(board.place));
    return (colour * (1.0F - 0.6F * gap)).eval();
  });
  return canvas;
}

Canvas PaintMetal() {
  Canvas canvas(256, 256);
  canvas.Fill([](float u, float v) {
    const float cloud = TilingFbm(u * 4, v * 4, 4, 4, 71);
    const float brush = TilingNoise(u * 8, v * 128, 128, 72);
    const float dirt = SmoothStep(0.55F, 0.85F, TilingFbm(u * 6, v * 6, 6, 5, 73));
    return Grey(0.90F + 0.08F * (cloud - 0.5F) + 0.05F * (brush - 0.5F) - 0.10F * dirt).eval();
  });
  PaintRandom random(74);
  for (int scratch = 0; scratch < 60; ++scratch) {
    const Eigen::Vector2f from(random.Uniform(0, 256), random.Uniform(0, 256));
    const Eigen::Vector2f way(random.Uniform(-24, 24), random.Uniform(-8, 8));
    canvas.Stroke(from, from + way, Grey(random.Uniform(0.7F, 1.0F)), 0.35F);
  }
  return canvas;
}

Canvas PaintRubber() {
  constexpr int kLugs = 4;
  Canvas canvas(128, 128);
  canvas.Fill([](float u, float v) {
    const Cell lug = CellOf(v, kLugs);
    const float grain = TilingFbm(u * 32, v * 32, 32, 3, 81);
    const float raised = SmoothStep(0.18F, 0.26F, lug.place) - SmoothStep(0.74F, 0.82F, lug.place);
    const float lip = SmoothStep(0.68F, 0.74F, lug.place) - SmoothStep(0.78F, 0.84F, lug.place);
    return Grey(0.21F + 0.13F * raised + 0.10F * lip + 0.08F * (grain - 0.5F)).eval();
  });
  return canvas;
}

Canvas PaintHazard() {
  Canvas canvas(256, 256);
  canvas.Fill([](float u, float v) {
    const float wear = TilingFbm(u * 12, v * 12, 12, 5, 91);
    const Cell stripe = CellOf(u + v, 2);
    const float dark =
        SmoothStep(0.49F, 0.51F, stripe.place) - SmoothStep(0.98F, 1.0F, stripe.place);
    const Colour paint = Mix(Colour(0.93F, 0.78F, 0.12F), Grey(0.13F), dark);
    return Mix((paint * (0.90F + 0.2F * (wear - 0.5F))).eval(), Grey(0.55F),
               0.55F * SmoothStep(0.66F, 0.78F, wear))
        .eval();
  });
  return canvas;
}

}  // namespace

int SurfaceTextureIndex(std::string_view name) {
  const auto found = std::find(kSurfaceTextures.begin(), kSurfaceTextures.end(), name);
  if (found == kSurfaceTextures.end()) {
    throw std::runtime_error(fmt::format("cameras: texture \"{}\" is unknown; there are {}", name,
                                         fmt::join(kSurfaceTextures, ", ")));
  }
  return static_cast<int>(found - kSurfaceTextures.begin());
}

Image PaintSurfaceTexture(int index) {
  constexpr std::array kPainters{
      &PaintPlain,    &PaintGrass,   &PaintConcrete,   &PaintBrick,  &PaintAsphalt, &PaintWood,
      &PaintMetal,    &PaintRubber,  &PaintHazard,     &PaintGravel, &PaintPaving,  &PaintRender,
      &PaintRooftile, &PaintWindows, &PaintShopwindow, &PaintFruit,  &PaintLeaves,  &PaintPlaster,
      &PaintCarpet,   &PaintTile,    &PaintCeiling,    &PaintBooks,  &PaintRack};
  static_assert(kPainters.size() == kSurfaceTextures.size());
  return kPainters.at(static_cast<size_t>(index))().ToImage();
}

Image PaintGroundVariation() {
  Canvas canvas(256, 256);
  canvas.Fill([](float u, float v) {
    return Colour(TilingFbm(u * 4, v * 4, 4, 6, 101), TilingFbm(u * 16, v * 16, 16, 4, 102), 0.5F);
  });
  return canvas.ToImage();
}

}  // namespace eod::sim
