#include <osg/Geode>
#include <osg/Geometry>
#include <osg/KdTree>
#include <osgUtil/IntersectionVisitor>
#include <osgUtil/LineSegmentIntersector>

#include "tests/bench/isector_bench/engine.h"
#include "tests/bench/isector_bench/osg_scene.h"

namespace eod::bench {

namespace {

/// One LineSegmentIntersector a segment, kept from frame to frame, that looks for the nearest hit.
class OsgEngine final : public Engine {
 public:
  explicit OsgEngine(const IndexedMesh& mesh) : middle_(mesh.middle), scene_(MakeOsgScene(mesh)) {}

  void Cast(std::span<const sim::SegmentQuery> lines, std::span<sim::SegmentHit> hits) override {
    for (size_t i = 0; i < lines.size(); ++i) Cast(lines[i], hits[i]);
  }

 private:
  void Cast(const sim::SegmentQuery& line, sim::SegmentHit& hit) {
    const Eigen::Vector3d start = line.start - middle_;
    intersector_->reset();
    intersector_->setStart(ToOsg(start));
    intersector_->setEnd(ToOsg(start + line.length * line.direction));
    visitor_.reset();
    visitor_.setIntersector(intersector_);
    scene_->accept(visitor_);
    hit.hit = intersector_->containsIntersections();
    if (!hit.hit) return;
    const auto& nearest = *intersector_->getIntersections().begin();
    hit.range = nearest.ratio * line.length;
    hit.point = line.start + hit.range * line.direction;
    const osg::Vec3& normal = nearest.localIntersectionNormal;
    hit.normal = Eigen::Vector3f(normal.x(), normal.y(), normal.z()).cast<double>();
  }

  Eigen::Vector3d middle_;
  osg::ref_ptr<osg::Node> scene_;
  osg::ref_ptr<osgUtil::LineSegmentIntersector> intersector_ = new osgUtil::LineSegmentIntersector(
      osgUtil::Intersector::MODEL, {}, {}, nullptr, osgUtil::Intersector::LIMIT_NEAREST);
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
