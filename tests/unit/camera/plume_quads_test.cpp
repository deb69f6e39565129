#include "sim/camera/plume_quads.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "sim/camera/plume_pass.h"

namespace eod::sim {
namespace {

using Eigen::Vector2d;

constexpr size_t kCorners = 6;  // of the two triangles of a quad

PlumeQuad At(float x, float y, float z, float half_size) {
  return {.p_M = {x, y, z}, .half_size = half_size, .colour = {1, 1, 1}, .alpha = 1, .angle = 0.7F};
}

/// A camera at the origin that looks along +Y.
std::vector<PlumeVertex> Seen(const std::vector<PlumeQuad>& quads) {
  std::vector<PlumeVertex> vertices;
  FaceCamera(quads, Eigen::Isometry3d::Identity(), Lens{}, vertices);
  return vertices;
}

/// Share of the picture that a quad's two triangles have.
double ShareOf(const std::vector<PlumeVertex>& vertices, size_t quad) {
  const auto corner = [&](size_t i) {
    const float* p = vertices.at(kCorners * quad + i).position;
    return Vector2d(p[0] / p[3], p[1] / p[3]);
  };
  double area = 0;
  for (const size_t first : {0U, 3U}) {
    const Vector2d a = corner(first + 1) - corner(first);
    const Vector2d b = corner(first + 2) - corner(first);
    area += std::abs(a.x() * b.y() - a.y() * b.x()) / 2;
  }
  return area / 4;  // clip space is 2 x 2
}

double ShareOfAll(const std::vector<PlumeVertex>& vertices) {
  double sum = 0;
  for (size_t quad = 0; quad < vertices.size() / kCorners; ++quad) sum += ShareOf(vertices, quad);
  return sum;
}

TEST(PlumeQuads, HaveTheirSizeFromAfar) {
  // 1 m across at 20 m, the picture 2 * 20 * tan(0.65) = 30.4 m wide and 3/4 of that high.
  const auto vertices = Seen({At(0, 20, 0, 0.5F)});
  ASSERT_EQ(vertices.size(), kCorners);
  const double width = 40 * std::tan(0.65);
  EXPECT_NEAR(ShareOf(vertices, 0), 1 / (width * width * 0.75), 1e-6);
}

TEST(PlumeQuads, NoQuadCoversMoreThanFifteenPercentOfThePicture) {
  for (const float distance : {0.5F, 1.0F, 2.0F, 5.0F}) {
    EXPECT_NEAR(ShareOf(Seen({At(0, distance, 0, 3)}), 0), 0.15, 1e-5) << distance << " m";
  }
}

TEST(PlumeQuads, AllTogetherCoverAtMostThreePictures) {
  // 32 quads of 15 % would be 480 %.
  const std::vector<PlumeQuad> crowd(32, At(0, 3, 0, 2));
  EXPECT_NEAR(ShareOfAll(Seen(crowd)), 3.0, 1e-4);
  // Twenty of them are just as much, and are left as they are.
  const std::vector<PlumeQuad> few(19, At(0, 3, 0, 2));
  EXPECT_NEAR(ShareOfAll(Seen(few)), 19 * 0.15, 1e-4);
}

TEST(PlumeQuads, FarthestComesFirst) {
  const auto vertices = Seen({At(0, 4, 0, 0.2F), At(0, 9, 0, 0.2F), At(0, 6, 0, 0.2F)});
  ASSERT_EQ(vertices.size(), 3 * kCorners);
  EXPECT_FLOAT_EQ(vertices[0].position[3], 9);
  EXPECT_FLOAT_EQ(vertices[kCorners].position[3], 6);
  EXPECT_FLOAT_EQ(vertices[2 * kCorners].position[3], 4);
}

TEST(PlumeQuads, LeavesOutWhatCannotBeSeen) {
  EXPECT_TRUE(Seen({At(0, -5, 0, 1), At(0, 0.1F, 0, 1), At(50, 5, 0, 1), At(0, 5, 50, 1)}).empty());
  // The centre is out of the picture, half of it is in.
  EXPECT_EQ(Seen({At(5 * std::tan(0.65F) + 0.2F, 5, 0, 0.5F)}).size(), kCorners);
}

TEST(PlumeQuads, FaceACameraThatIsTurned) {
  Eigen::Isometry3d X_MC = Eigen::Isometry3d::Identity();
  X_MC.rotate(Eigen::AngleAxisd(1.2, Eigen::Vector3d(0.2, 0.3, 1).normalized()));
  X_MC.pretranslate(Eigen::Vector3d(3, 2, 1));
  PlumeQuad quad = At(0, 0, 0, 0.5F);
  quad.p_M = (X_MC * Eigen::Vector3d(0, 20, 0)).cast<float>();
  std::vector<PlumeVertex> vertices;
  FaceCamera(std::vector{quad}, X_MC, Lens{}, vertices);
  ASSERT_EQ(vertices.size(), kCorners);
  EXPECT_NEAR(ShareOf(vertices, 0), ShareOf(Seen({At(0, 20, 0, 0.5F)}), 0), 1e-6);
}

TEST(PlumeTexture, IsSoftClearAtItsRimAndHalfAsDenseAtSixTenths) {
  const Image puff = PaintPuff();
  ASSERT_EQ(puff.width, 64);
  ASSERT_EQ(puff.height, 64);
  const auto alpha = [&](int x, int y) {
    return static_cast<int>(puff.rgba.at(static_cast<size_t>(4 * (64 * y + x) + 3)));
  };
  double around = 0;
  constexpr int kPlaces = 64;
  for (int i = 0; i < kPlaces; ++i) {
    const double turn = 6.2832 * i / kPlaces;
    around += alpha(static_cast<int>(32 + 0.6 * 32 * std::cos(turn)),
                    static_cast<int>(32 + 0.6 * 32 * std::sin(turn)));
  }
  EXPECT_NEAR(around / kPlaces, 0.5 * 255, 0.12 * 255);
  EXPECT_GT(alpha(32, 32), 200);
  for (int i = 0; i < 64; ++i) {
    for (const int rim : {alpha(i, 0), alpha(i, 63), alpha(0, i), alpha(63, i)}) EXPECT_EQ(rim, 0);
  }
  for (int y = 0; y < 64; ++y) {
    for (int x = 1; x < 64; ++x) {
      ASSERT_LT(std::abs(alpha(x, y) - alpha(x - 1, y)), 60) << "no hard edge";
    }
  }
}

}  // namespace
}  // namespace eod::sim
