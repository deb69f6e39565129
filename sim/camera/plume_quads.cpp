#include "sim/camera/plume_quads.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace eod::sim {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kNearest = 0.25;     // [m] quads nearer to the camera are not drawn
constexpr double kClearBefore = 1.0;  // [m] and from here on they thin out
constexpr float kSunOnTop = 0.35F;    // smoke is lighter above and darker below

/// A quad as the camera has it: Y ahead, X right, Z up.
struct FacingQuad {
  const PlumeQuad* quad;
  Vector3d p_C;
  double half_size;
};

/// Pictures have four corners: a quad's own may reach 1.41 half sizes off its centre.
bool IsInPicture(const FacingQuad& facing, double zoom, double aspect) {
  const double reach = facing.half_size * std::numbers::sqrt2;
  const Vector3d& p_C = facing.p_C;
  return p_C.y() > kNearest && zoom * (std::abs(p_C.x()) - reach) < p_C.y() &&
         zoom * aspect * (std::abs(p_C.z()) - reach) < p_C.y();
}

class Billboards {
 public:
  Billboards(const Lens& lens, std::vector<PlumeVertex>& vertices)
      : clip_(ClipFromCamera(lens)), nearest_(2 * lens.near), vertices_(vertices) {}

  void Append(const FacingQuad& facing) {
    const PlumeQuad& quad = *facing.quad;
    const double turn = static_cast<double>(quad.angle);
    const Vector2d along = facing.half_size * Vector2d(std::cos(turn), std::sin(turn));
    const Vector2d across(-along.y(), along.x());
    constexpr std::array<std::array<float, 2>, 4> kCorners{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
    for (const size_t corner : {0, 1, 2, 0, 2, 3}) {
      const auto& [u, v] = kCorners[corner];
      Append(facing, (2.0 * u - 1) * along + (2.0 * v - 1) * across, u, v);
    }
  }

 private:
  void Append(const FacingQuad& facing, const Vector2d& offset, double u, double v) {
    const PlumeQuad& quad = *facing.quad;
    const Vector3d p_C = facing.p_C + Vector3d(offset.x(), 0, offset.y());
    Eigen::Vector4d place = clip_ * p_C.homogeneous();
    // A puff is a ball: its depth is that of its front, so that ground does not cut it in half.
    const double front = std::max(p_C.y() - facing.half_size, nearest_);
    place.z() = (clip_(2, 1) + clip_(2, 3) / front) * place.w();
    const double clear = (facing.p_C.y() - kNearest) / (kClearBefore - kNearest);
    const auto lit = static_cast<float>(offset.y() / facing.half_size) * kSunOnTop * quad.cover;
    const Eigen::Vector3f colour = quad.colour * (1 + lit);
    vertices_.push_back({{static_cast<float>(place.x()), static_cast<float>(place.y()),
                          static_cast<float>(place.z()), static_cast<float>(place.w())},
                         {static_cast<float>(u), static_cast<float>(v)},
                         {colour.x(), colour.y(), colour.z(),
                          quad.alpha * static_cast<float>(std::clamp(clear, 0.0, 1.0))},
                         quad.cover});
  }

  Eigen::Matrix4d clip_;
  double nearest_;
  std::vector<PlumeVertex>& vertices_;
};

}  // namespace

void FaceCamera(std::span<const PlumeQuad> quads, const Eigen::Isometry3d& X_MC, const Lens& lens,
                std::vector<PlumeVertex>& vertices) {
  vertices.clear();
  if (quads.empty()) return;
  const double zoom = ClipFromCamera(lens)(0, 0);
  const Eigen::Isometry3d X_CM = X_MC.inverse();
  std::vector<FacingQuad> facing;
  facing.reserve(quads.size());
  double covered = 0;  // shares of the picture
  for (const PlumeQuad& quad : quads) {
    FacingQuad one{&quad, X_CM * quad.p_M.cast<double>(), static_cast<double>(quad.half_size)};
    one.half_size =
        std::min(one.half_size, one.p_C.y() / zoom * std::sqrt(kMostOfAQuad / lens.aspect));
    if (!IsInPicture(one, zoom, lens.aspect)) continue;
    const double share = zoom * one.half_size / one.p_C.y();
    covered += share * share * lens.aspect;
    facing.push_back(one);
  }
  if (covered > kMostOfAllQuads) {
    for (FacingQuad& one : facing) one.half_size *= std::sqrt(kMostOfAllQuads / covered);
  }
  std::stable_sort(facing.begin(), facing.end(),
                   [](const auto& a, const auto& b) { return a.p_C.y() > b.p_C.y(); });
  Billboards billboards(lens, vertices);
  for (const FacingQuad& one : facing) billboards.Append(one);
}

}  // namespace eod::sim
