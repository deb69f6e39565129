#include "sim/geometry/mesh.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "sim/geometry/obj_file.h"

namespace eod::sim {
namespace {

using Eigen::Vector3d;

/// Volume enclosed by a closed mesh; positive if its triangles face outwards.
double Volume(const Mesh& mesh) {
  double sixfold = 0;
  for (const auto& [a, b, c] : mesh) sixfold += a.dot(b.cross(c));
  return sixfold / 6;
}

TEST(Mesh, BoxEnclosesItsVolume) {
  EXPECT_NEAR(Volume(BoxMesh({2, 3, 4})), 24, 1e-12);
  EXPECT_EQ(BoxMesh({2, 3, 4}).size(), 12u);
}

TEST(Mesh, RoundShapesEncloseTheVolumeOfTheirPrism) {
  // Area of a regular n-gon in a circle: n/2 r^2 sin(2 pi / n).
  const double polygon = 24.0 / 2 * 0.25 * std::sin(2 * std::numbers::pi / 24);
  EXPECT_NEAR(Volume(CylinderMesh(0.5, 2, 24)), polygon * 2, 1e-12);
  EXPECT_NEAR(Volume(ConeMesh(0.5, 2, 24)), polygon * 2 / 3, 1e-12);
}

TEST(Mesh, SphereComesCloseFromInside) {
  const double whole = 4.0 / 3 * std::numbers::pi;
  EXPECT_LT(Volume(SphereMesh(1, 16, 32)), whole);
  EXPECT_GT(Volume(SphereMesh(1, 16, 32)), 0.97 * whole);
}

TEST(Mesh, CapsuleIsItsSphereAndItsPrism) {
  const double sphere = Volume(SphereMesh(0.5, 8, 24)), prism = Volume(CylinderMesh(0.5, 2, 24));
  EXPECT_NEAR(Volume(CapsuleMesh(0.5, 2, 8, 24)), sphere + prism, 1e-12);
}

TEST(Mesh, PlaneIsCutIntoCellsThatFaceUp) {
  const Mesh mesh = PlaneMesh(10, 4, 2);
  EXPECT_EQ(mesh.size(), 5u * 2u * 2u);
  for (const auto& [a, b, c] : mesh) EXPECT_NEAR((b - a).cross(c - a).z(), 4, 1e-12);
}

class ObjFile : public ::testing::Test {
 protected:
  std::filesystem::path Write(const std::string& text) {
    const auto file =
        std::filesystem::temp_directory_path() / ("mesh_test_" + std::to_string(getpid()) + ".obj");
    std::ofstream(file) << text;
    return file;
  }
};

TEST_F(ObjFile, PolygonsAreCutIntoFans) {
  const auto file = Write("# unit square\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1/1 2/2 -2//1 4\n");
  const Mesh mesh = ReadObj(file);
  ASSERT_EQ(mesh.size(), 2u);
  EXPECT_EQ(mesh[0][2], Vector3d(1, 1, 0));
  EXPECT_EQ(mesh[1][1], Vector3d(1, 1, 0));
  EXPECT_EQ(mesh[1][2], Vector3d(0, 1, 0));
}

TEST_F(ObjFile, NumbersOfAllKindsAreRead) {
  const Mesh mesh =
      ReadObj(Write("# a comment\r\nv +1.5 -2e-1\t.25\r\nv 1 0 0 1\n"
                    "v 0 1 0\nvn 0 0 1\n\nf 1/1/1 -2//1 3"));
  ASSERT_EQ(mesh.size(), 1u);
  EXPECT_EQ(mesh[0][0], Vector3d(1.5, -0.2, 0.25));
  EXPECT_EQ(mesh[0][1], Vector3d(1, 0, 0));
  EXPECT_EQ(mesh[0][2], Vector3d(0, 1, 0));
}

TEST_F(ObjFile, MissingNumberIsNamed) {
  for (const char* text : {"v 0 0\n", "v 0 0 x\n"}) {
    EXPECT_THAT([&] { ReadObj(Write(text)); },
                testing::ThrowsMessage<std::runtime_error>(testing::AllOf(
                    testing::HasSubstr(":1: "), testing::HasSubstr("needs three numbers"))));
  }
}

TEST_F(ObjFile, BadLineIsNamed) {
  const auto file = Write("v 0 0 0\nf 1 2 3\n");
  EXPECT_THAT([&] { ReadObj(file); }, testing::ThrowsMessage<std::runtime_error>(testing::AllOf(
                                          testing::StartsWith(file.string() + ":2: "),
                                          testing::HasSubstr("corner 2 of 1"))));
}

}  // namespace
}  // namespace eod::sim
