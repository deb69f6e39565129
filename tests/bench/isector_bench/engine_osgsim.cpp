#include <osgSim/HeightAboveTerrain>
#include <osgSim/LineOfSight>

#include "tests/bench/isector_bench/engine.h"
#include "tests/bench/isector_bench/osg_scene.h"

namespace eod::bench {

namespace {

/// Heights of the starts of vertical lines of one length and height, so of TRIPOD.
class HeightEngine final : public Engine {
 public:
  explicit HeightEngine(const IndexedMesh& mesh)
      : middle_(mesh.middle), scene_(MakeOsgScene(mesh)) {
    heights_.setDatabaseCacheReadCallback(nullptr);  // there is nothing to load
  }

  void Cast(std::span<const sim::SegmentQuery> lines, std::span<sim::SegmentHit> hits) override {
    while (heights_.getNumPoints() < lines.size()) heights_.addPoint({});
    for (size_t i = 0; i < lines.size(); ++i)
      heights_.setPoint(static_cast<unsigned>(i), ToOsg(lines[i].start - middle_));
    const sim::SegmentQuery& first = lines.front();
    heights_.setLowestHeight(first.start.z() - middle_.z() - first.length);
    heights_.computeIntersections(scene_);
    for (size_t i = 0; i < lines.size(); ++i) {
      sim::SegmentHit& hit = hits[i];
      // Without a hit it gives the point's own z; TRIPOD always has one here.
      hit.range = heights_.getHeightAboveTerrain(static_cast<unsigned>(i));
      hit.hit = hit.range >= 0 && hit.range <= lines[i].length;
      hit.point = lines[i].start + hit.range * lines[i].direction;
    }
  }

 private:
  Eigen::Vector3d middle_;
  osg::ref_ptr<osg::Node> scene_;
  osgSim::HeightAboveTerrain heights_;
};

/// All lines as lines of sight; of each one's list of hits the first.
class SightEngine final : public Engine {
 public:
  explicit SightEngine(const IndexedMesh& mesh) : middle_(mesh.middle), scene_(MakeOsgScene(mesh)) {
    sights_.setDatabaseCacheReadCallback(nullptr);
  }

  void Cast(std::span<const sim::SegmentQuery> lines, std::span<sim::SegmentHit> hits) override {
    if (sights_.getNumLOS() != lines.size()) {
      sights_.clear();
      for (size_t i = 0; i < lines.size(); ++i) sights_.addLOS({}, {});
    }
    for (unsigned i = 0; i < lines.size(); ++i) {
      const Eigen::Vector3d start = lines[i].start - middle_;
      sights_.setStartPoint(i, ToOsg(start));
      sights_.setEndPoint(i, ToOsg(start + lines[i].length * lines[i].direction));
    }
    sights_.computeIntersections(scene_);
    for (unsigned i = 0; i < lines.size(); ++i) {
      sim::SegmentHit& hit = hits[i];
      const auto& all = sights_.getIntersections(i);
      hit.hit = !all.empty();
      if (!hit.hit) continue;
      hit.point = Eigen::Vector3d(all[0].x(), all[0].y(), all[0].z()) + middle_;
      hit.range = (hit.point - lines[i].start).dot(lines[i].direction);
    }
  }

 private:
  Eigen::Vector3d middle_;
  osg::ref_ptr<osg::Node> scene_;
  osgSim::LineOfSight sights_;
};

}  // namespace

std::unique_ptr<Engine> BuildOsgSimHat(const Source& source) {
  return std::make_unique<HeightEngine>(source.mesh);
}

std::unique_ptr<Engine> BuildOsgSimLos(const Source& source) {
  return std::make_unique<SightEngine>(source.mesh);
}

}  // namespace eod::bench
