#include <algorithm>
#include <array>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/camera/jpeg_encoder.h"
#include "sim/camera/noise.h"
#include "sim/camera/sky_panorama.h"
#include "sim/camera/surface_mesh.h"
#include "sim/camera/surface_textures.h"
#include "sim/camera/view.h"

namespace eod::sim {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

TEST(Noise, RepeatsAtItsPeriodWithoutASeam) {
  for (const float x : {0.0F, 0.3F, 3.99F}) {
    EXPECT_FLOAT_EQ(TilingNoise(x, 1.25F, 5, 7), TilingNoise(x + 5, 1.25F, 5, 7));
    EXPECT_FLOAT_EQ(TilingNoise(1.25F, x, 5, 7), TilingNoise(1.25F, x - 5, 5, 7));
  }
}

TEST(SurfaceTextures, AreTheSameInEveryRunAndDifferByName) {
  std::vector<std::vector<uint8_t>> seen;
  for (int i = 0; i < static_cast<int>(kSurfaceTextures.size()); ++i) {
    const Image image = PaintSurfaceTexture(i);
    EXPECT_EQ(PaintSurfaceTexture(i).rgba, image.rgba);
    EXPECT_EQ(image.rgba.size(), static_cast<size_t>(image.width * image.height * 4));
    EXPECT_EQ(std::count(seen.begin(), seen.end(), image.rgba), 0)
        << kSurfaceTextures.at(static_cast<size_t>(i));
    seen.push_back(image.rgba);
  }
}

TEST(SkyPanorama, RowsAndElevationsAreInverse) {
  for (const float v : {0.0F, 0.2F, 0.5F, 1.0F}) {
    EXPECT_NEAR(PanoramaRow(PanoramaElevation(v)), v, 1e-5);
  }
}

TEST(SkyPanorama, SunStandsWhereItsLightComesFrom) {
  // Sun in the east (u = 0.25 is +X), 45 degrees up.
  Atmosphere air;
  air.sun_direction = Vector3f(1, 0, 1).normalized();
  constexpr int kWidth = 512;
  constexpr int kHeight = 256;
  const Image sky = PaintSkyPanorama(LightingOf(air, {}).sky, kWidth, kHeight);
  const auto brightness = [&](float u, float elevation) {
    const int x = static_cast<int>(u * kWidth);
    const int y = static_cast<int>(PanoramaRow(elevation) * kHeight);
    const uint8_t* pixel = &sky.rgba.at(static_cast<size_t>(y * kWidth + x) * 4);
    return pixel[0] + pixel[1] + pixel[2];
  };
  EXPECT_GT(brightness(0.25F, 0.785F), 740);  // nearly 3 * 255
  EXPECT_LT(brightness(0.75F, 0.785F), 740);
}

TEST(SurfaceMesh, ChamferedBoxIsClosedAndFacesOutwards) {
  Visual box;
  box.size = {1, 2, 3};
  SurfaceMesh mesh;
  AppendVisual(box, Eigen::Isometry3d::Identity(), 0, {.chamfer = 0.1}, mesh);
  // 6 faces and 12 edges of two triangles each, 8 corners of one.
  EXPECT_EQ(mesh.indices.size() / 3, 44U);
  // With c = 0.1 an edge of length L loses a prism of c^2/2 (L - 2c), all 12 together
  // 0.005 * (24 - 2.4) = 0.108; a corner loses c^3 less a tetrahedron of c^3/6, all 8 0.00667.
  double volume = 0;
  for (size_t i = 0; i < mesh.indices.size(); i += 3) {
    std::array<Vector3d, 3> corner;
    for (size_t k = 0; k < 3; ++k) {
      corner[k] = Vector3f(mesh.vertices[mesh.indices[i + k]].position).cast<double>();
    }
    volume += corner[0].dot(corner[1].cross(corner[2])) / 6;
  }
  EXPECT_NEAR(volume, 6 - 0.11467, 1e-4);  // by the divergence theorem
}

TEST(SurfaceMesh, RoundShapesFaceOutwards) {
  for (const auto shape :
       {Visual::Shape::kCylinder, Visual::Shape::kCone, Visual::Shape::kSphere}) {
    Visual visual;
    visual.shape = shape;
    visual.size = {0.5, 0.5, 1};
    SurfaceMesh mesh;
    AppendVisual(visual, Eigen::Isometry3d::Identity(), 3, {}, mesh);
    for (size_t i = 0; i < mesh.indices.size(); i += 3) {
      std::array<Vector3f, 3> corner;
      for (size_t k = 0; k < 3; ++k)
        corner[k] = Vector3f(mesh.vertices[mesh.indices[i + k]].position);
      const Vector3f normal = (corner[1] - corner[0]).cross(corner[2] - corner[0]);
      // The shapes are convex around the origin.
      EXPECT_GE(normal.dot(corner[0] + corner[1] + corner[2]), -1e-6F);
    }
    EXPECT_EQ(mesh.vertices[0].bone, 3);
  }
}

TEST(View, CameraLooksAlongItsYAxisWithZUp) {
  const View view = MakeCameraView(Eigen::Isometry3d::Identity(), {.horizontal_fov = 1.5707963});
  const auto project = [&](const Vector3d& point) {
    return Vector3d((view.clip * point.homogeneous()).hnormalized());
  };
  // 90 degrees wide: 1 m to the right at 1 m ahead lies on the right edge.
  EXPECT_NEAR(project({1, 1, 0}).x(), 1, 1e-6);
  EXPECT_NEAR(project({0, 5, 0}).head<2>().norm(), 0, 1e-12);
  EXPECT_GT(project({0, 5, 1}).y(), 0);
  EXPECT_LT(project({0, 5, 0}).z(), project({0, 6, 0}).z());
}

TEST(Frustum, LeavesOutBoxesBehindAndBeside) {
  const Frustum dut(MakeCameraView(Eigen::Isometry3d::Identity(), {.horizontal_fov = 1.5707963}));
  const auto box = [](float x, float y) {
    return Eigen::AlignedBox3f(Vector3f(x, y, 0), Vector3f(x + 1, y + 1, 1));
  };
  EXPECT_TRUE(dut.MaySee(box(0, 5)));
  EXPECT_TRUE(dut.MaySee(box(4.5F, 5)));
  EXPECT_FALSE(dut.MaySee(box(0, -5)));
  EXPECT_FALSE(dut.MaySee(box(9, 5)));
}

TEST(JpegEncoder, LowersTheQualityUntilTheMostDifficultPictureFits) {
  constexpr int kWidth = 640;
  constexpr int kHeight = 480;
  std::vector<uint8_t> rgba(kWidth * kHeight * 4);
  PaintRandom random(1);
  for (uint8_t& byte : rgba) byte = static_cast<uint8_t>(random.Uniform(0, 256));
  JpegEncoder dut(kWidth, kHeight, 80);
  const auto jpeg = dut.Encode(rgba);
  EXPECT_FALSE(jpeg.empty());
  EXPECT_LE(jpeg.size(), JpegEncoder::kMaxBytes);
  EXPECT_LT(dut.last_quality(), 80);
  // The next easy picture has its full quality again.
  std::fill(rgba.begin(), rgba.end(), uint8_t{90});
  dut.Encode(rgba);
  EXPECT_EQ(dut.last_quality(), 80);
}

}  // namespace
}  // namespace eod::sim
