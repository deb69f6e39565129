#include "sim/camera/isector_overlay.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace eod::sim {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::Vector4d;

constexpr double kNearest = 0.05;       // [m] in front of the camera
constexpr double kHalfWidth = 1.25;     // [px]
constexpr double kCrossHalfSize = 6.0;  // [px]

class Ribbons {
 public:
  Ribbons(const View& view, int width, int height, std::vector<ColourVertex>& triangles)
      : view_(view), half_size_(width / 2.0, height / 2.0), triangles_(triangles) {}

  void Line(const Vector3d& p_MA, const Vector3d& p_MB, const uint8_t* colour) {
    Vector4d from = view_.clip * p_MA.homogeneous();
    Vector4d to = view_.clip * p_MB.homogeneous();
    if (from.w() < kNearest && to.w() < kNearest) return;
    if (from.w() > to.w()) std::swap(from, to);
    if (from.w() < kNearest) from += (to - from) * ((kNearest - from.w()) / (to.w() - from.w()));
    PixelLine(ToPixels(from), ToPixels(to), colour);
  }

  void Cross(const Vector3d& p_MH, const uint8_t* colour) {
    const Vector4d point = view_.clip * p_MH.homogeneous();
    if (point.w() < kNearest) return;
    const Vector2d centre = ToPixels(point);
    for (const double sign : {-1.0, 1.0}) {
      const Vector2d arm(kCrossHalfSize, sign * kCrossHalfSize);
      PixelLine(centre - arm, centre + arm, colour);
    }
  }

 private:
  Vector2d ToPixels(const Vector4d& clip) const {
    return (clip.head<2>() / clip.w()).cwiseProduct(half_size_);
  }

  void PixelLine(const Vector2d& from, const Vector2d& to, const uint8_t* colour) {
    const Vector2d way = to - from;
    const Vector2d along =
        way.norm() > 1e-6 ? Vector2d(way.normalized() * kHalfWidth) : Vector2d(kHalfWidth, 0);
    const Vector2d across(-along.y(), along.x());
    const Vector2d corners[4] = {from - along - across, to + along - across, to + along + across,
                                 from - along + across};
    for (const int corner : {0, 1, 2, 0, 2, 3}) {
      const Vector2d place = corners[corner].cwiseQuotient(half_size_);
      ColourVertex vertex{{static_cast<float>(place.x()), static_cast<float>(place.y()), 0},
                          {colour[0], colour[1], colour[2], colour[3]}};
      triangles_.push_back(vertex);
    }
  }

  const View& view_;
  Vector2d half_size_;
  std::vector<ColourVertex>& triangles_;
};

const uint8_t* ColourOf(const DrawnSegment& segment) {
  if (segment.contact) return kContactColour;
  return segment.hit ? kHitColour : kFreeColour;
}

}  // namespace

void AppendSegments(std::span<const DrawnSegment> segments, const View& view, int width, int height,
                    std::vector<ColourVertex>& triangles) {
  Ribbons ribbons(view, width, height, triangles);
  for (const DrawnSegment& segment : segments) {
    // Clipped at its hit: legs of TRIPOD would reach out of the far side of the ground.
    const Vector3d& end = segment.hit ? segment.point : segment.end;
    ribbons.Line(segment.start, end, ColourOf(segment));
  }
  // Crosses last: a hit must be seen among many lines.
  for (const DrawnSegment& segment : segments) {
    if (segment.hit) ribbons.Cross(segment.point, ColourOf(segment));
  }
}

}  // namespace eod::sim
