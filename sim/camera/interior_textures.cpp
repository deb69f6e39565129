#include "sim/camera/interior_textures.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/camera/noise.h"

namespace eod::sim {
namespace {

using Colour = Eigen::Vector3f;

/// Where in a repeating cell: its number, and 0..1 within.
struct Place {
  int cell;
  float within;
};

Place PlaceIn(float coordinate, int cells) {
  const float scaled = coordinate * static_cast<float>(cells);
  const float floor = std::floor(scaled);
  return {static_cast<int>(floor), scaled - floor};
}

/// 1 within `width` of a cell's edges, in shares of the cell.
float OnEdge(float within, float width) {
  const float edge = std::min(within, 1.0F - within);
  return std::clamp(1.5F - edge / width, 0.0F, 1.0F);
}

/// Rows of units, each 0..1 wide and high, from bottom to top.
constexpr int kUnits = 12;

Colour RackUnit(float u, float within, int unit) {
  const float kind = LatticeValue(unit, 3, 141);
  const float gap = OnEdge(within, 0.06F);
  float value = 0.10F + 0.06F * LatticeValue(unit, 5, 142);
  if (kind < 0.35F && within > 0.25F && within < 0.75F) {  // drives side by side
    value += 0.10F * (1.0F - OnEdge(PlaceIn(u, 10).within, 0.10F));
  } else if (kind > 0.7F) {  // grille
    value += 0.07F * (PlaceIn(u, 42).within > 0.5F ? 1.0F : 0.0F);
  }
  Colour colour = Colour::Constant(value * (1.0F - 0.7F * gap));
  const Place lamp = PlaceIn(u, 26);
  const bool is_lamp = lamp.within > 0.3F && lamp.within < 0.75F && within > 0.80F &&
                       within < 0.92F && LatticeValue(lamp.cell % 26, unit, 143) > 0.62F;
  if (is_lamp)
    colour = LatticeValue(lamp.cell % 26, unit, 144) > 0.2F ? Colour(0.2F, 1.0F, 0.35F)
                                                            : Colour(1.0F, 0.65F, 0.1F);
  return colour;
}

}  // namespace

Canvas PaintPlaster() {
  Canvas canvas(128, 128);
  canvas.Fill([](float u, float v) {
    const float cloud = TilingFbm(u * 3, v * 3, 3, 2, 111);
    const float grain = TilingNoise(u * 64, v * 64, 64, 112);
    return Colour::Constant(0.93F + 0.06F * (cloud - 0.5F) + 0.05F * (grain - 0.5F)).eval();
  });
  return canvas;
}

Canvas PaintCarpet() {
  Canvas canvas(128, 128);
  canvas.Fill([](float u, float v) {
    const float loop = TilingNoise(u * 64, v * 64, 64, 115);
    const float fleck = TilingNoise(u * 32, v * 32, 32, 116);
    const Place column = PlaceIn(u, 2), row = PlaceIn(v, 2);
    const float seam = std::max(OnEdge(column.within, 0.012F), OnEdge(row.within, 0.012F));
    const bool turned = (column.cell + row.cell) % 2 == 0;
    const float rib = PlaceIn(turned ? u : v, 32).within;
    return Colour::Constant(0.72F + 0.24F * (loop - 0.5F) + 0.16F * (fleck - 0.5F) +
                            0.10F * (rib - 0.5F) - 0.12F * seam)
        .eval();
  });
  return canvas;
}

Canvas PaintTile() {
  Canvas canvas(256, 256);
  canvas.Fill([](float u, float v) {
    const Place column = PlaceIn(u, 2), row = PlaceIn(v, 2);
    const float joint = std::max(OnEdge(column.within, 0.012F), OnEdge(row.within, 0.012F));
    const float cloud = TilingFbm(u * 5, v * 5, 5, 2, 121);
    const float tone = LatticeValue(column.cell & 1, row.cell & 1, 122);
    const float value = 0.84F + 0.05F * (tone - 0.5F) + 0.14F * (cloud - 0.5F) - 0.30F * joint;
    return Colour(value, value * 0.985F, value * 0.955F);
  });
  return canvas;
}

Canvas PaintCeiling() {
  Canvas canvas(256, 256);
  canvas.Fill([](float u, float v) {
    const float frame =
        std::max(OnEdge(PlaceIn(u, 2).within, 0.022F), OnEdge(PlaceIn(v, 2).within, 0.022F));
    const float pore = TilingNoise(u * 80, v * 80, 80, 131) > 0.84F ? 0.10F : 0.0F;
    const float panel = 0.90F - pore;
    return Colour::Constant(frame > 0.9F ? 0.99F : panel - 0.18F * frame).eval();
  });
  return canvas;
}

Canvas PaintBooks() {
  constexpr int kBacks = 22;
  static const std::array kCloth{Colour(0.42F, 0.10F, 0.09F), Colour(0.10F, 0.20F, 0.40F),
                                 Colour(0.12F, 0.30F, 0.18F), Colour(0.80F, 0.76F, 0.66F),
                                 Colour(0.15F, 0.15F, 0.16F), Colour(0.70F, 0.52F, 0.16F),
                                 Colour(0.40F, 0.42F, 0.45F)};
  Canvas canvas(256, 256);
  canvas.Fill([&](float u, float v) {
    const Place row = PlaceIn(v, 2), back = PlaceIn(u, kBacks);
    const int number = back.cell % kBacks;
    const float height = 0.62F + 0.24F * LatticeValue(number, row.cell & 1, 151);
    if (row.within > height) return Colour(0.05F, 0.045F, 0.04F);
    const auto cloth = static_cast<size_t>(LatticeValue(number, row.cell & 1, 152) * 6.99F);
    const float shade = 1.0F - 0.55F * OnEdge(back.within, 0.14F);
    const float title = row.within / height;
    const bool lettered =
        title > 0.55F && title < 0.82F && back.within > 0.3F && back.within < 0.7F;
    return Colour(lettered ? Colour(0.88F, 0.85F, 0.74F) * shade : kCloth.at(cloth) * shade);
  });
  return canvas;
}

Canvas PaintRack() {
  Canvas canvas(256, 256);
  canvas.Fill([](float u, float v) {
    const Place unit = PlaceIn(v, kUnits);
    if (u < 0.05F || u > 0.95F) return Colour(0.05F, 0.05F, 0.055F);
    return RackUnit(u, unit.within, unit.cell % kUnits);
  });
  return canvas;
}

}  // namespace eod::sim
