#include "sim/segments/shape.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sim/geometry/mesh.h"
#include "tests/unit/sim/random_scene.h"

namespace eod::sim {
namespace {

using Eigen::Vector3d;

const Vector3d kX = Vector3d::UnitX(), kY = Vector3d::UnitY(), kZ = Vector3d::UnitZ();
constexpr double kExact = 1e-15;

/// Corners of a box: a hull that must answer as the box does.
std::vector<Vector3d> CornersOf(const Vector3d& size) {
  std::vector<Vector3d> corners;
  for (int i = 0; i < 8; ++i) {
    const Vector3d sign((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1, (i & 4) != 0 ? 1 : -1);
    corners.push_back(sign.cwiseProduct(size) / 2);
  }
  return corners;
}

/// Solids that reach from -0.5 to 0.5 along X, with their surface across X there.
struct Solids {
  const char* name;
  Shape shape;
};

std::vector<Solids> MetreWide() {
  return {{"Box", Shape::Box({1, 2, 3})},
          {"Cylinder", Shape::Cylinder(0.5, 3)},
          {"Sphere", Shape::Sphere(0.5)},
          {"Capsule", Shape::Capsule(0.5, 2)},
          {"Hull", Shape::Hull(CornersOf({1, 2, 3}))}};
}

class EveryShape : public ::testing::TestWithParam<size_t> {
 protected:
  Shape dut_ = MetreWide()[GetParam()].shape;

  /// Along +X from (x, 0, 0).
  Crossings FromX(double x, double length) { return dut_.Cross({x, 0, 0}, kX, length); }
};

TEST_P(EveryShape, IsEnteredAndLeft) {
  const Crossings found = FromX(-2, 4);
  ASSERT_EQ(found.count, 2u);
  EXPECT_NEAR(found.list[0].range, 1.5, kExact);
  EXPECT_NEAR(found.list[1].range, 2.5, kExact);
  EXPECT_LT((found.list[0].normal + kX).norm(), kExact);
  EXPECT_LT((found.list[1].normal - kX).norm(), kExact);
  EXPECT_TRUE(found.list[0].entry);
  EXPECT_FALSE(found.list[1].entry);
}

TEST_P(EveryShape, IsOnlyLeftFromInside) {
  const Crossings found = FromX(0.1, 4);
  ASSERT_EQ(found.count, 1u);
  EXPECT_NEAR(found.list[0].range, 0.4, kExact);
  EXPECT_LT((found.list[0].normal - kX).norm(), kExact);
  EXPECT_FALSE(found.list[0].entry);
}

TEST_P(EveryShape, IsNotMetBySegmentsThatStayWithinOrShortOfIt) {
  EXPECT_EQ(FromX(-0.4, 0.8).count, 0u);
  EXPECT_EQ(FromX(-2, 1.4999).count, 0u);
  EXPECT_EQ(FromX(0.5001, 4).count, 0u);
  EXPECT_EQ(dut_.Cross({-2, 0, 2.1}, kX, 4).count, 0u);
}

TEST_P(EveryShape, CountsStartsAndEndsOnItsSurface) {
  ASSERT_EQ(FromX(-2, 1.5).count, 1u);  // ends on the near face
  EXPECT_EQ(FromX(-2, 1.5).list[0].range, 1.5);
  ASSERT_EQ(FromX(-0.5, 0.9).count, 1u);  // starts on it, inwards
  EXPECT_EQ(FromX(-0.5, 0.9).list[0].range, 0);
  EXPECT_TRUE(FromX(-0.5, 0.9).list[0].entry);
  ASSERT_EQ(FromX(0.5, 1).count, 1u);  // starts on the far face, outwards
  EXPECT_EQ(FromX(0.5, 1).list[0].range, 0);
  EXPECT_FALSE(FromX(0.5, 1).list[0].entry);
  ASSERT_EQ(FromX(-0.4, 0.9).count, 1u);  // ends on the far face from inside
  EXPECT_EQ(FromX(-0.4, 0.9).list[0].range, 0.9);
  // Half a nanometre beyond an end counts as on it, two do not.
  EXPECT_EQ(FromX(-2, 1.5 - 0.5e-9).count, 1u);
  EXPECT_EQ(FromX(-2, 1.5 - 2e-9).count, 0u);
  EXPECT_EQ(FromX(0.5 + 0.5e-9, 1).count, 1u);
  EXPECT_EQ(FromX(0.5 + 0.5e-9, 1).list[0].range, 0);
  EXPECT_EQ(FromX(0.5 + 2e-9, 1).count, 0u);
}

TEST_P(EveryShape, MeetsAPointOnItsSurfaceWhateverItsDirection) {
  for (const Vector3d& direction : {kX, Vector3d(-kX), kY, kZ}) {
    const Crossings found = dut_.Cross({0.5, 0, 0}, direction, 0);
    ASSERT_EQ(found.count, 1u);
    EXPECT_EQ(found.list[0].range, 0);
    EXPECT_LT((found.list[0].normal - kX).norm(), kExact);
    EXPECT_EQ(found.list[0].entry, direction.x() < 0);
  }
  EXPECT_EQ(dut_.Cross(Vector3d::Zero(), kX, 0).count, 0u);
  EXPECT_EQ(dut_.Cross({0.5 + 2e-9, 0, 0}, kX, 0).count, 0u);
  EXPECT_EQ(dut_.Cross({0.5 - 2e-9, 0, 0}, kX, 0).count, 0u);
}

TEST_P(EveryShape, LiesWithinItsBoundsAndFillsThem) {
  SeededNumbers numbers(31);
  for (int i = 0; i < 200; ++i) {
    Eigen::Isometry3d X_MS(Eigen::Translation3d(numbers.InBox(10)));
    const double angle = numbers.Between(0, std::numbers::pi);
    X_MS.linear() = Eigen::AngleAxisd(angle, numbers.InBox(1).normalized()).toRotationMatrix();
    const Eigen::AlignedBox3d bounds = dut_.Bounds(X_MS);
    for (int axis = 0; axis < 3; ++axis) {
      // Just outside of each face of the bounds no point is met; just inside, one is.
      for (const double side : {-1.0, 1.0}) {
        const auto met_at = [&](double shift) {
          const double face = side > 0 ? bounds.max()[axis] : bounds.min()[axis];
          for (int j = 0; j < 400; ++j) {
            Vector3d p_M = bounds.center() + numbers.InBox(1).cwiseProduct(bounds.sizes() / 2);
            p_M[axis] = face + side * shift;
            const Vector3d direction = Vector3d::Unit((axis + 1) % 3);
            const Eigen::Isometry3d X_SM = X_MS.inverse();
            if (dut_.Cross(X_SM * (p_M - 10 * direction), X_SM.linear() * direction, 20).count > 0)
              return true;
          }
          return false;
        };
        ASSERT_FALSE(met_at(1e-6));
        ASSERT_TRUE(met_at(-0.05 * bounds.sizes()[axis]));
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, EveryShape, ::testing::Range<size_t>(0, 5),
                         [](const auto& one) { return MetreWide()[one.param].name; });

TEST(RoundShapes, TangentIsOneTouchAndNoEntry) {
  for (const Shape& dut : {Shape::Cylinder(0.5, 3), Shape::Sphere(0.5), Shape::Capsule(0.5, 2)}) {
    const Crossings found = dut.Cross({-2, 0.5, 0}, kX, 4);
    ASSERT_EQ(found.count, 1u);
    EXPECT_EQ(found.list[0].range, 2);
    EXPECT_LT((found.list[0].normal - kY).norm(), kExact);
    EXPECT_FALSE(found.list[0].entry);
    EXPECT_EQ(dut.Cross({-2, 0.5 + 0.5e-9, 0}, kX, 4).count, 1u);  // within the tolerance
    EXPECT_EQ(dut.Cross({-2, 0.5 + 2e-9, 0}, kX, 4).count, 0u);
    EXPECT_EQ(dut.Cross({-2, 0.5 - 2e-9, 0}, kX, 4).count, 2u);
  }
}

TEST(FlatFaces, LineInAFaceMeetsTheRimOfTheFace) {
  for (const Shape& dut : {Shape::Box({1, 2, 3}), Shape::Hull(CornersOf({1, 2, 3}))}) {
    const Crossings found = dut.Cross({-2, 0, 1.5}, kX, 4);  // in the top
    ASSERT_EQ(found.count, 2u);
    EXPECT_EQ(found.list[0].range, 1.5);
    EXPECT_EQ(found.list[1].range, 2.5);
    EXPECT_EQ(dut.Cross({-0.4, 0, 1.5}, kX, 0.8).count, 0u);  // within the face: no rim
    EXPECT_EQ(dut.Cross({-2, 0, 1.5 + 2e-9}, kX, 4).count, 0u);
  }
  const Shape drum = Shape::Cylinder(0.5, 3);
  ASSERT_EQ(drum.Cross({-2, 0, -1.5}, kX, 4).count, 2u);
  EXPECT_EQ(drum.Cross({-2, 0, -1.5}, kX, 4).list[0].range, 1.5);
  // Along its side: the rims of both caps.
  ASSERT_EQ(drum.Cross({0.5, 0, -2}, kZ, 4).count, 2u);
  EXPECT_EQ(drum.Cross({0.5, 0, -2}, kZ, 4).list[0].range, 0.5);
}

TEST(FlatFaces, EdgeIsTouchedOnce) {
  // Past the edge x = 0.5, y = 1 at 45 degrees.
  const Vector3d direction = Vector3d(-1, 1, 0).normalized();
  const double to_edge = std::numbers::sqrt2;
  for (const Shape& dut : {Shape::Box({1, 2, 3}), Shape::Hull(CornersOf({1, 2, 3}))}) {
    const auto past = [&](double outwards) {
      return dut.Cross(Vector3d(1.5, 0, 0) + outwards * Vector3d(1, 1, 0).normalized(), direction,
                       4);
    };
    ASSERT_EQ(past(0).count, 1u);
    EXPECT_NEAR(past(0).list[0].range, to_edge, 1e-12);
    EXPECT_FALSE(past(0).list[0].entry);
    EXPECT_EQ(past(0.5e-9).count, 1u);
    EXPECT_EQ(past(3e-9).count, 0u);
    EXPECT_EQ(past(-3e-9).count, 2u);  // a chord of 6 nm
  }
}

TEST(Shape, SizeThatMakesNoSolidIsAnError) {
  const auto message = [](const auto& make) -> std::string {
    try {
      make();
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(message([] { Shape::Sphere(0); }),
            "radius of a sphere = 0 m, needs a finite length of 1e-06 m or more");
  EXPECT_EQ(message([] {
              Shape::Box({1, -2, 1});
            }),
            "size of a box = -2 m, needs a finite length of 1e-06 m or more");
  EXPECT_EQ(message([] { Shape::Capsule(0.1, std::nan("")); }),
            "length of a capsule = nan m, needs a finite length of 1e-06 m or more");
  EXPECT_EQ(message([] { Shape::Cylinder(std::numeric_limits<double>::infinity(), 1); }),
            "radius of a cylinder = inf m, needs a finite length of 1e-06 m or more");
  EXPECT_EQ(message([] {
              Shape::Hull(std::vector<Vector3d>{kX, kY, kZ});
            }),
            "convex hull: 3 points have no volume");
  EXPECT_EQ(message([] { Shape::Hull({}); }), "convex hull: 0 points have no volume");
}

TEST(ConvexHull, PointsWithoutVolumeAreAnError) {
  SeededNumbers numbers(41);
  const std::vector<Vector3d> one_place(10, kX);
  std::vector<Vector3d> row, sheet, thin;
  for (int i = 0; i < 20; ++i) {
    const double a = numbers.Between(-1, 1), b = numbers.Between(-1, 1);
    row.push_back(a * Vector3d(1, 2, 3));
    sheet.push_back(a * Vector3d(1, 2, 3) + b * Vector3d(-1, 0.5, 2));
    thin.push_back({a, b, numbers.Between(-1e-7, 1e-7)});
  }
  EXPECT_THROW(HullOf(one_place), std::runtime_error);
  EXPECT_THROW(HullOf(row), std::runtime_error);
  EXPECT_THROW(HullOf(sheet), std::runtime_error);
  EXPECT_THROW(HullOf(thin), std::runtime_error);
  EXPECT_THROW(HullOf(std::vector<Vector3d>{kX, kY, kZ, Vector3d::Constant(std::nan(""))}),
               std::runtime_error);
}

TEST(ConvexHull, OfACubeHasEightCornersAndSixFacesWhateverElseIsGiven) {
  // Doubled corners, points in the faces, on the edges and inside.
  SeededNumbers numbers(42);
  std::vector<Vector3d> points = CornersOf({2, 2, 2});
  for (int i = 0; i < 300; ++i) {
    Vector3d point = numbers.InBox(1);
    for (int axis = 0; axis < static_cast<int>(numbers.Below(4)); ++axis) {
      point[axis] = numbers.Below(2) == 0 ? -1 : 1;
    }
    points.push_back(point);
  }
  const ConvexHull dut = HullOf(points);
  EXPECT_EQ(dut.corners.size(), 8u);
  ASSERT_EQ(dut.planes.size(), 6u);
  for (const HullPlane& plane : dut.planes) {
    EXPECT_NEAR(plane.offset, 1, 1e-12);
    EXPECT_NEAR(plane.normal.cwiseAbs().maxCoeff(), 1, 1e-12);
  }
}

TEST(ConvexHull, OfPointsOnABallHasThemAllForCorners) {
  SeededNumbers numbers(43);
  std::vector<Vector3d> points;
  for (int i = 0; i < 400; ++i) points.push_back(3 * numbers.InBox(1).normalized());
  const ConvexHull dut = HullOf(points);
  EXPECT_EQ(dut.corners.size(), 400u);
  EXPECT_EQ(dut.planes.size(), 2u * 400 - 4);  // Euler: triangles of a closed surface
  for (const HullPlane& plane : dut.planes) {
    for (const Vector3d& point : points) ASSERT_LE(plane.normal.dot(point), plane.offset);
  }
}

TEST(ConvexHull, OfARoundMeshIsFlatWhereTheMeshIs) {
  // 24 sides and two caps, each cap of 24 corners and a middle in one plane.
  std::vector<Vector3d> points;
  for (const Triangle& triangle : CylinderMesh(0.5, 1, 24)) {
    points.insert(points.end(), triangle.begin(), triangle.end());
  }
  const ConvexHull dut = HullOf(points);
  EXPECT_GE(dut.corners.size(), 48u);
  EXPECT_EQ(dut.planes.size(), 26u);
}

}  // namespace
}  // namespace eod::sim
