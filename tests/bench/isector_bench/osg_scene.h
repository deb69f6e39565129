#pragma once

#include <osg/Node>
#include <osg/Vec3d>
#include <osg/ref_ptr>

#include "tests/bench/isector_bench/indexed_mesh.h"

namespace eod::bench {

/// One geometry with a KdTree by KdTreeBuilder. Its vertices are in single precision, so they are
/// counted from the middle of the mesh, as OpenSceneGraph's users place large models.
osg::ref_ptr<osg::Node> MakeOsgScene(const IndexedMesh& mesh);

inline osg::Vec3d ToOsg(const Eigen::Vector3d& p) { return {p.x(), p.y(), p.z()}; }

}  // namespace eod::bench
