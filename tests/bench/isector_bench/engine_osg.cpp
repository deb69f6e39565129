#include <map>

#include <osg/Geode>
#include <osg/Geometry>
#include <osg/KdTree>
#include <osgUtil/IntersectionVisitor>
#include <osgUtil/LineSegmentIntersector>

#include "tests/bench/isector_bench/engine.h"
#include "tests/bench/isector_bench/osg_scene.h"

namespace eod::bench {

namespace {

/// One IntersectorGroup for all lines of a frame, kept from frame to frame, whose intersectors look
/// for the nearest hit. A visitor a line is up to a tenth slower; single precision in the
/// intersection is no faster.
class OsgEngine final : public Engine {
 public:
  explicit OsgEngine(const IndexedMesh& mesh) : middle_(mesh.middle), scene_(MakeOsgScene(mesh)) {}

  void Cast(std::span<const sim::SegmentQuery> lines, std::span<sim::SegmentHit> hits) override {
    Lines& kept = LinesFor(lines.size());
    kept.group->reset();
    for (size_t i = 0; i < lines.size(); ++i) {
      const Eigen::Vector3d start = lines[i].start - middle_;
      kept.each[i]->setStart(ToOsg(start));
      kept.each[i]->setEnd(ToOsg(start + lines[i].length * lines[i].direction));
    }
    visitor_.reset();
    visitor_.setIntersector(kept.group);
    scene_->accept(visitor_);
    for (size_t i = 0; i < lines.size(); ++i) Read(lines[i], *kept.each[i], hits[i]);
  }

 private:
  struct Lines {
    osg::ref_ptr<osgUtil::IntersectorGroup> group = new osgUtil::IntersectorGroup;
    std::vector<osg::ref_ptr<osgUtil::LineSegmentIntersector>> each;
  };

  Lines& LinesFor(size_t count) {
    Lines& lines = kept_[count];
    while (lines.each.size() < count) {
      lines.each.push_back(new osgUtil::LineSegmentIntersector(
          osgUtil::Intersector::MODEL, {}, {}, nullptr, osgUtil::Intersector::LIMIT_NEAREST));
      lines.group->addIntersector(lines.each.back());
    }
    return lines;
  }

  static void Read(const sim::SegmentQuery& line, osgUtil::LineSegmentIntersector& intersector,
                   sim::SegmentHit& hit) {
    hit.hit = intersector.containsIntersections();
    if (!hit.hit) return;
    const auto& nearest = *intersector.getIntersections().begin();
    hit.range = nearest.ratio * line.length;
    hit.point = line.start + hit.range * line.direction;
    const osg::Vec3& normal = nearest.localIntersectionNormal;
    hit.normal = Eigen::Vector3f(normal.x(), normal.y(), normal.z()).cast<double>();
  }

  Eigen::Vector3d middle_;
  osg::ref_ptr<osg::Node> scene_;
  std::map<size_t, Lines> kept_;  // by lines a frame
  osgUtil::IntersectionVisitor visitor_;
};

}  // namespace

osg::ref_ptr<osg::Node> MakeOsgScene(const IndexedMesh& mesh) {
  const osg::ref_ptr<osg::Vec3Array> corners = new osg::Vec3Array;
  corners->reserve(mesh.corners.size());
  for (const Eigen::Vector3d& corner : mesh.corners)
    corners->push_back(osg::Vec3(ToOsg(corner - mesh.middle)));
  const osg::ref_ptr<osg::DrawElementsUInt> indices =
      new osg::DrawElementsUInt(osg::PrimitiveSet::TRIANGLES);
  indices->reserve(3 * mesh.triangles.size());
  for (const auto& triangle : mesh.triangles) {
    for (const uint32_t corner : triangle) indices->push_back(corner);
  }
  const osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
  geometry->setVertexArray(corners);
  geometry->addPrimitiveSet(indices);
  const osg::ref_ptr<osg::Geode> geode = new osg::Geode;
  geode->addDrawable(geometry);
  const osg::ref_ptr<osg::KdTreeBuilder> builder = new osg::KdTreeBuilder;
  geode->accept(*builder);
  geode->getBound();
  return geode;
}

std::unique_ptr<Engine> BuildOsg(const Source& source) {
  return std::make_unique<OsgEngine>(source.mesh);
}

}  // namespace eod::bench
