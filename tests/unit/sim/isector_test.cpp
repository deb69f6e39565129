#include "sim/isectors/isector.h"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/isectors/isector_batch.h"
#include "sim/isectors/isector_methods.h"
#include "sim/isectors/terrain_reading.h"
#include "sim/isectors/tripod_reading.h"
#include "sim/world/analytic_world.h"

namespace eod::sim {
namespace {

using Eigen::Vector3d;
using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr uint32_t kWall = kModuleFlat | kBumpProxy;
constexpr uint32_t kGround = kModuleFlat | kClampProxy;

Eigen::Isometry3d At(double x, double y, double z) {
  return Eigen::Isometry3d(Eigen::Translation3d(x, y, z));
}

/// Floors of no thickness that reach everywhere, and the only world here that lists all hits.
/// Meets downward segments alone.
class Floors final : public World {
 public:
  explicit Floors(std::vector<double> heights) : heights_(std::move(heights)) {}  // falling

  void Cast(std::span<const SegmentQuery> queries, std::span<SegmentHit> hits,
            CastMemory& memory) const override {
    ++casts;
    for (size_t i = 0; i < queries.size(); ++i) {
      hits[i] = {};
      groups.push_back(queries[i].group);
      for (const double height : heights_) {
        const double range = queries[i].start.z() - height;
        if (range < 0 || range > queries[i].length) continue;
        SegmentHit hit{.hit = true, .range = range};
        hit.point = queries[i].start - range * Vector3d::UnitZ();
        if (!hits[i].hit) hits[i] = hit;
        if (queries[i].hit_rule != HitRule::kAll) continue;
        memory.all.push_back({.query = static_cast<int>(i), .hit = hit});
      }
    }
  }
  const std::string& ObjectName(int) const override { return name_; }

  mutable int casts = 0;
  mutable std::vector<uint32_t> groups;  ///< of all queries, in order

 private:
  std::vector<double> heights_;
  std::string name_ = "floor";
};

class IsectorTest : public ::testing::Test {
 protected:
  AnalyticWorld world_;
  IsectorBatch batch_;

  void Cast(Isector& isector, int64_t step) { batch_.CastIsectors({&isector, 1}, world_, step); }
};

TEST_F(IsectorTest, ResultsCarryPointNormalRangeObjectAndClass) {
  world_.AddPlane("other", kGround, {0, 0, -1}, Vector3d::UnitZ());
  world_.AddPlane("wall", kWall, {0, 3, 0}, -Vector3d::UnitY());
  Isector dut = MakeLos("sight", 10);
  dut.set_pose(At(0.5, 1, 2));
  Cast(dut, 1);
  const SegmentHit& hit = dut.Hit(0, 1);
  ASSERT_TRUE(hit.hit);
  EXPECT_EQ(hit.point, Vector3d(0.5, 3, 2));
  EXPECT_EQ(hit.normal, -Vector3d::UnitY());
  EXPECT_DOUBLE_EQ(hit.range, 2);
  EXPECT_EQ(world_.ObjectName(hit.object), "wall");
  EXPECT_EQ(hit.object_class, kWall);
  EXPECT_EQ(hit.triangle, -1);  // an exact shape
}

TEST_F(IsectorTest, ReadingAnotherStepIsAnErrorThatNamesBoth) {
  Isector dut = MakeBump("B1", {1, 1, 1, 1, 1, 1});
  Cast(dut, 7);
  EXPECT_NO_THROW(dut.Hit(kPlusY, 7));
  EXPECT_THAT([&] { dut.Hit(kPlusY, 8); },
              ThrowsMessage<StaleReading>(
                  "isector B1 segment 2: read in step 8, but it was last cast in step 7"));
  try {
    dut.Hit(kPlusY, 8);
  } catch (const StaleReading& stale) {
    EXPECT_EQ(stale.asked_step(), 8);
    EXPECT_EQ(stale.cast_step(), 7);
  }
}

TEST_F(IsectorTest, EveryReadingIsCheckedForItsStep) {
  std::vector<Isector> duts = {MakeHat("hat"), MakeZ("z"), MakeZpr("zpr"), MakeXyzpr("xyzpr"),
                               MakeTripod("tripod", {Vector3d(-1, 1, 0), {1, 1, 0}, {0, -1, 0}})};
  batch_.CastIsectors(duts, world_, 1);
  EXPECT_THROW(ReadHat(duts[0], 2), StaleReading);
  EXPECT_THROW(ReadZ(duts[1], 2), StaleReading);
  EXPECT_THROW(ReadZpr(duts[2], 2), StaleReading);
  EXPECT_THROW(ReadXyzpr(duts[3], 2), StaleReading);
  EXPECT_THROW(ReadTripod(duts[4], 2), StaleReading);
  EXPECT_THROW(duts[0].PoseOfCast(0), StaleReading);
  EXPECT_THROW(duts[0].AllHits(0, 2), StaleReading);
  EXPECT_FALSE(duts[0].IsFresh(2));
  EXPECT_TRUE(duts[0].IsFresh(1));
}

TEST_F(IsectorTest, NeverCastHasNothingToRead) {
  const Isector dut = MakeLos("sight", 1);
  EXPECT_THAT([&] { dut.Hit(0, 0); },
              ThrowsMessage<StaleReading>(HasSubstr("read in step 0, but it was never cast")));
}

TEST_F(IsectorTest, DisabledIsectorIsNotCastAndNotRead) {
  std::vector<Isector> duts = {MakeLos("on", 1), MakeLos("off", 1)};
  batch_.CastIsectors(duts, world_, 1);
  duts[1].set_enabled(false);
  batch_.CastIsectors(duts, world_, 2);
  EXPECT_EQ(batch_.queries().size(), 1u);
  EXPECT_NO_THROW(duts[0].Hit(0, 2));
  EXPECT_THROW(duts[1].Hit(0, 2), StaleReading);
}

TEST_F(IsectorTest, DisabledSegmentIsNotCastAndNotRead) {
  world_.AddPlane("wall", kWall, {0, 0.5, 0}, -Vector3d::UnitY());
  Isector dut = MakeBump("B1", {1, 1, 1, 1, 1, 1});
  dut.EnableSegment(kMinusY, false);
  Cast(dut, 1);
  EXPECT_EQ(batch_.queries().size(), 5u);
  EXPECT_TRUE(dut.Hit(kPlusY, 1).hit);
  EXPECT_FALSE(dut.IsFresh(1, kMinusY));
  EXPECT_THROW(dut.Hit(kMinusY, 1), StaleReading);
}

TEST_F(IsectorTest, SeesTheClassesOfItsMaskAlone) {
  world_.AddPlane("bomb", kModuleBomb | kBombObject, {0, 1, 0}, -Vector3d::UnitY());
  world_.AddPlane("wall", kModuleFlat | kBumpProxy, {0, 2, 0}, -Vector3d::UnitY());
  Isector dut = MakeLos("sight", 10);
  const auto object = [&](uint32_t class_mask, int64_t step) {
    dut.set_class_mask(class_mask);
    Cast(dut, step);
    return world_.ObjectName(dut.Hit(0, step).object);
  };
  EXPECT_EQ(object(kBombObject | kBumpProxy, 1), "bomb");
  EXPECT_EQ(object(kBumpProxy, 2), "wall");
  EXPECT_EQ(object(kModuleFlat | kBombObject | kBumpProxy, 3), "wall");
  EXPECT_EQ(object(kContainmentVessel, 4), "");
}

TEST_F(IsectorTest, LooksForLooseThingsAsForWallsUnlessItLooksForGround) {
  for (const uint32_t kind : {kBumpProxy, kBombObject, kMovableObject, kContainmentVessel}) {
    EXPECT_TRUE(Accepts(kModuleFlat | UsualClasses(IsectorMethod::kBump), kModuleFlat | kind));
    EXPECT_FALSE(Accepts(kModuleFlat | UsualClasses(IsectorMethod::kTripod), kModuleFlat | kind));
  }
  EXPECT_TRUE(Accepts(kModuleFlat | UsualClasses(IsectorMethod::kTripod), kGround));
  EXPECT_FALSE(Accepts(kModuleFlat | UsualClasses(IsectorMethod::kLos), kGround));
}

TEST_F(IsectorTest, FrontOnlyPassesThroughFacesThatLookAway) {
  world_.AddPlane("away", kWall, {0, 1, 0}, Vector3d::UnitY());
  world_.AddPlane("towards", kWall, {0, 2, 0}, -Vector3d::UnitY());
  Isector dut = MakeLos("sight", 10);
  Cast(dut, 1);
  EXPECT_DOUBLE_EQ(dut.Hit(0, 1).range, 1);
  dut.set_face_rule(FaceRule::kFrontOnly);
  Cast(dut, 2);
  EXPECT_DOUBLE_EQ(dut.Hit(0, 2).range, 2);
}

TEST_F(IsectorTest, HighestHitIsTheFarOneOfASegmentThatRises) {
  for (const double z : {1.0, 2.0}) {
    world_.AddPlane("ceiling", kWall, {0, 0, z}, -Vector3d::UnitZ());
  }
  Isector dut = MakeVolume("up", {{.direction = Vector3d::UnitZ(), .length = 5}});
  Cast(dut, 1);
  EXPECT_DOUBLE_EQ(dut.Hit(0, 1).point.z(), 1);
  dut.set_hit_rule(HitRule::kHighest);
  Cast(dut, 2);
  EXPECT_DOUBLE_EQ(dut.Hit(0, 2).point.z(), 2);
}

TEST_F(IsectorTest, HitRuleAllListsEveryHitOfItsOwnSegmentsByRange) {
  const Floors world({0.4, 0.1, -0.2});
  std::vector<Isector> duts = {MakeHat("highest", {-1, 1}), MakeHat("all", {-1, 1}),
                               MakeTripod("legs", {Vector3d(-1, 1, 0), {1, 1, 0}, {0, -1, 0}})};
  duts[1].set_hit_rule(HitRule::kAll);
  duts[2].set_hit_rule(HitRule::kAll);
  duts[2].set_pose(At(0, 0, -0.1));  // legs begin at 0.35, below the uppermost floor
  batch_.CastIsectors(duts, world, 1);

  const auto heights = [&](const Isector& isector, int segment) {
    std::vector<double> z;
    for (const SegmentHit& hit : isector.AllHits(segment, 1)) z.push_back(hit.point.z());
    return z;
  };
  using testing::DoubleEq;
  using testing::ElementsAre;
  EXPECT_THAT(heights(duts[0], 0), ElementsAre(DoubleEq(0.4)));
  EXPECT_THAT(heights(duts[1], 0), ElementsAre(DoubleEq(0.4), DoubleEq(0.1), DoubleEq(-0.2)));
  for (int leg = 0; leg < 3; ++leg) {
    EXPECT_THAT(heights(duts[2], leg), ElementsAre(DoubleEq(0.1), DoubleEq(-0.2)));
  }
  EXPECT_DOUBLE_EQ(duts[1].Hit(0, 1).point.z(), 0.4);
}

TEST_F(IsectorTest, NoHitListsNone) {
  const Floors world({});
  Isector dut = MakeHat("hat");
  for (const HitRule rule : {HitRule::kNearest, HitRule::kAll}) {
    dut.set_hit_rule(rule);
    batch_.CastIsectors({&dut, 1}, world, 1);
    EXPECT_TRUE(dut.AllHits(0, 1).empty());
  }
}

TEST_F(IsectorTest, ManyAreCastInOneCallAndEachIsAGroup) {
  const Floors world({0});
  std::vector<Isector> duts = {MakeBump("B1", {1, 1, 1, 1, 1, 1}), MakeHat("hat"),
                               MakeTripod("legs", {Vector3d(-1, 1, 0), {1, 1, 0}, {0, -1, 0}})};
  batch_.CastIsectors(duts, world, 1);
  EXPECT_EQ(world.casts, 1);
  EXPECT_EQ(world.groups, (std::vector<uint32_t>{0, 0, 0, 0, 0, 0, 1, 2, 2, 2}));
  EXPECT_EQ(batch_.IsectorOf(8), 2);
  EXPECT_EQ(batch_.SegmentOf(8), 1);
}

TEST_F(IsectorTest, ResultStaysThatOfItsCastWhenTheIsectorMovesOn) {
  const Floors world({0});
  Isector dut = MakeHat("hat");
  dut.set_pose(At(0, 0, 0.3));
  batch_.CastIsectors({&dut, 1}, world, 1);
  dut.set_pose(At(0, 0, 5));
  EXPECT_DOUBLE_EQ(ReadHat(dut, 1).value(), 0.3);
}

TEST_F(IsectorTest, LengthCanBeChangedBetweenCasts) {
  world_.AddPlane("wall", kWall, {0, 2, 0}, -Vector3d::UnitY());
  Isector dut = MakeLos("sight", 1);
  Cast(dut, 1);
  EXPECT_FALSE(dut.Hit(0, 1).hit);
  dut.SetLength(0, 2);  // a hit at the far end counts
  Cast(dut, 2);
  EXPECT_TRUE(dut.Hit(0, 2).hit);
  EXPECT_THROW(dut.SetLength(0, -1), std::invalid_argument);
  EXPECT_THROW(dut.SetLength(1, 1), std::out_of_range);
}

TEST_F(IsectorTest, ALineCanBeReplacedBetweenCasts) {
  world_.AddPlane("wall", kWall, {0, 2, 0}, -Vector3d::UnitY());
  Isector dut = MakeLos("sight", 1);
  dut.SetSegment(0, {.start = {0, 1.5, 0}, .direction = Vector3d::UnitY(), .length = 1});
  Cast(dut, 1);
  EXPECT_DOUBLE_EQ(dut.Hit(0, 1).range, 0.5);
  dut.SetSegment(0, {.direction = -Vector3d::UnitY(), .length = 5});
  Cast(dut, 2);
  EXPECT_FALSE(dut.Hit(0, 2).hit);
  EXPECT_THROW(dut.SetSegment(0, {.direction = {0, 2, 0}}), std::invalid_argument);
  EXPECT_THROW(dut.SetSegment(1, {}), std::out_of_range);
}

TEST(IsectorErrors, NameTheIsectorAndTheValue) {
  const auto volume = [](size_t count, const IsectorSegment& segment) {
    return [=] { MakeVolume("V1", std::vector<IsectorSegment>(count, segment)); };
  };
  using std::invalid_argument;
  EXPECT_THAT(volume(0, {}),
              ThrowsMessage<invalid_argument>("isector V1: 0 segments, method volume has 1..32"));
  EXPECT_NO_THROW(volume(32, {})());
  EXPECT_THAT(volume(33, {}), ThrowsMessage<invalid_argument>(HasSubstr("33 segments")));
  EXPECT_THAT(volume(1, {.direction = {0, 2, 0}}),
              ThrowsMessage<invalid_argument>(HasSubstr("a direction of length 2")));
  EXPECT_THAT(volume(1, {.length = -0.5}),
              ThrowsMessage<invalid_argument>(HasSubstr("V1: length -0.5 m")));
  EXPECT_THAT(volume(1, {.length = std::numeric_limits<double>::quiet_NaN()}),
              ThrowsMessage<invalid_argument>(HasSubstr("length nan")));
  EXPECT_THAT([] { MakeHat("H", {.z_min = 1, .z_max = 0}); },
              ThrowsMessage<invalid_argument>(HasSubstr("H: length -1 m")));
  EXPECT_THAT(
      [] {
        MakeTripod("T", {Vector3d(0, 0, 0), {0, 1, 0}, {0, 2, 0}});
      },
      ThrowsMessage<invalid_argument>("isector T: its legs stand in one line"));
  EXPECT_THAT([] { ReadHat(MakeZ("Z1"), 1); },
              ThrowsMessage<invalid_argument>("isector Z1: method z, read as hat"));
}

}  // namespace
}  // namespace eod::sim
