#include "sim/stance/resting_plane.h"

#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/sim/random_scene.h"

namespace eod::sim {
namespace {

using Eigen::Vector2d;

/// Four corners of a table, and a thing in the middle.
std::vector<Prop> Table(double middle) {
  return {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {0, 0, middle}};
}

RestingPlane Rest(const std::vector<Prop>& props, const Vector2d& centre) {
  std::array<int, 3> start;
  EXPECT_TRUE(FindTriangle(props, centre, start));
  return RestOn(props, centre, start);
}

/// Height at the centre of the lowest plane above all props, by trying all planes through three.
double LowestByTrying(const std::vector<Prop>& props, const Vector2d& centre) {
  double lowest = 1e9;
  const auto n = static_cast<int>(props.size());
  for (int a = 0; a < n; ++a) {
    for (int b = a + 1; b < n; ++b) {
      for (int c = b + 1; c < n; ++c) {
        const std::array<double, 3> load = LoadOn(props, {a, b, c}, centre);
        if (*std::min_element(load.begin(), load.end()) < 0) continue;
        const double height =
            load[0] * props[a].height + load[1] * props[b].height + load[2] * props[c].height;
        const std::array<Prop, 3> three = {props[a], props[b], props[c]};
        const RestingPlane plane = RestOn(three, centre, {0, 1, 2});
        bool above = true;
        for (const Prop& prop : props) above &= prop.height <= plane.At(prop.x, prop.y) + 1e-9;
        if (above) lowest = std::min(lowest, height);
      }
    }
  }
  return lowest;
}

TEST(RestingPlane, LiesOnLevelPropsWithoutAPivot) {
  const RestingPlane plane = Rest(Table(-0.5), {0.2, 0.1});
  EXPECT_EQ(plane.offset, 0);
  EXPECT_EQ(plane.slope, Vector2d::Zero());
  EXPECT_EQ(plane.pivots, 0);
  EXPECT_NEAR(plane.load[0] + plane.load[1] + plane.load[2], 1, 1e-12);
}

TEST(RestingPlane, TipsOverWhatSticksOutTowardsTheCentreOfGravity) {
  // On the thing in the middle, 0.3 high, and on the two corners on the side of the centre.
  const RestingPlane right = Rest(Table(0.3), {0.2, 0});
  EXPECT_NEAR(right.offset, 0.3, 1e-12);
  EXPECT_NEAR(right.slope.x(), -0.3, 1e-12);
  EXPECT_NEAR(right.slope.y(), 0, 1e-12);
  const RestingPlane rear = Rest(Table(0.3), {0, -0.2});
  EXPECT_NEAR(rear.slope.y(), 0.3, 1e-12);
}

TEST(RestingPlane, IsAboveAllPropsAndLowestAtTheCentre) {
  SeededNumbers numbers(4);
  for (int trial = 0; trial < 300; ++trial) {
    std::vector<Prop> props = {{-1, -1, 0}, {1, -1, 0}, {0, 1.5, 0}};
    for (int i = 0; i < 9; ++i) {
      props.push_back({numbers.Between(-1, 1), numbers.Between(-1, 1), numbers.Between(-1, 1)});
    }
    const Vector2d centre(numbers.Between(-0.2, 0.2), numbers.Between(-0.2, 0.2));
    const RestingPlane plane = Rest(props, centre);
    for (const Prop& prop : props) EXPECT_LE(prop.height, plane.At(prop.x, prop.y) + 1e-9);
    EXPECT_NEAR(plane.At(centre.x(), centre.y()), LowestByTrying(props, centre), 1e-9) << trial;
  }
}

TEST(RestingPlane, DoesNotDependOnWhereItStarts) {
  SeededNumbers numbers(5);
  std::vector<Prop> props = {{-1, -1, 0}, {1, -1, 0}, {0, 1.5, 0}, {-0.9, -1, 0}};
  for (int i = 0; i < 40; ++i) {
    props.push_back({numbers.Between(-1, 1), numbers.Between(-1, 1), numbers.Between(-1, 1)});
  }
  const Vector2d centre(0.03, -0.07);
  const RestingPlane one = RestOn(props, centre, {0, 1, 2});
  const RestingPlane other = Rest(props, centre);
  EXPECT_NEAR(one.At(centre.x(), centre.y()), other.At(centre.x(), centre.y()), 1e-9);
  EXPECT_LT(one.pivots, 30);
}

TEST(RestingPlane, EndsAndCarriesEverythingWherePropsStandInLinesAndGrids) {
  // Equal heights, equal places, three in a line: what makes a simplex run in circles.
  SeededNumbers numbers(6);
  for (int trial = 0; trial < 300; ++trial) {
    std::vector<Prop> props;
    for (int x = -2; x <= 2; ++x) {
      for (int y = -2; y <= 2; ++y) {
        props.push_back({x * 0.5, y * 0.5, 0.1 * static_cast<double>(numbers.Below(3))});
      }
    }
    props.push_back(props[3]);
    const Vector2d centre(0.25 * static_cast<double>(numbers.Below(3)), 0);
    const RestingPlane plane = Rest(props, centre);
    EXPECT_LT(plane.pivots, 64);  // of 96
    for (const Prop& prop : props) EXPECT_LE(prop.height, plane.At(prop.x, prop.y) + 1e-9);
  }
}

TEST(FindTriangle, FindsNoneOutsideAllProps) {
  std::array<int, 3> triangle;
  EXPECT_FALSE(FindTriangle(Table(0), {1.01, 0}, triangle));
  EXPECT_FALSE(FindTriangle(Table(0), {-0.5, -1.2}, triangle));
  EXPECT_TRUE(FindTriangle(Table(0), {0.99, 0.98}, triangle));
}

TEST(LoadOn, SharesTheWeightByTheLevers) {
  const std::vector<Prop> props = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const std::array<double, 3> load = LoadOn(props, {0, 1, 2}, {0.2, 0.3});
  EXPECT_NEAR(load[0], 0.5, 1e-12);
  EXPECT_NEAR(load[1], 0.2, 1e-12);
  EXPECT_NEAR(load[2], 0.3, 1e-12);
  EXPECT_LT(LoadOn(props, {0, 1, 1}, {0.2, 0.3})[0], 0);  // no area
}

}  // namespace
}  // namespace eod::sim
