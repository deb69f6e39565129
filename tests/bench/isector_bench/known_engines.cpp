#include "tests/bench/isector_bench/engine.h"

// Peers but Bullet are optional packages; CMake says which were found.
#ifdef EOD_BENCH_EMBREE
#define EOD_IF_EMBREE(build) build
#else
#define EOD_IF_EMBREE(build) nullptr
#endif
#ifdef EOD_BENCH_OSG
#define EOD_IF_OSG(build) build
#else
#define EOD_IF_OSG(build) nullptr
#endif

namespace eod::bench {

std::vector<EngineSpec> KnownEngines() {
  // OpenSceneGraph's lines of sight take 30 us and more from 1e6 on: minutes for all rounds, and
  // nothing new to learn.
  constexpr int64_t kMostOsg = 1000000;
  const std::string bullet = "libbullet-dev", embree = "libembree-dev",
                    osg = "libopenscenegraph-dev";
  return {
      {.name = "ours", .build = BuildOurs},
      {.name = "ours_plain", .build = BuildOursPlain},
      {.name = "bullet", .package = bullet, .build = BuildBullet},
      {.name = "embree", .package = embree, .build = EOD_IF_EMBREE(BuildEmbree)},
      {.name = "embree_robust", .package = embree, .build = EOD_IF_EMBREE(BuildEmbreeRobust)},
      {.name = "osg", .package = osg, .most_triangles = kMostOsg, .build = EOD_IF_OSG(BuildOsg)},
      {.name = "osgsim_los",
       .package = osg,
       .most_triangles = kMostOsg,
       .build = EOD_IF_OSG(BuildOsgSimLos)},
      {.name = "osgsim_hat",
       .package = osg,
       .most_triangles = kMostOsg,
       .legs_only = true,
       .build = EOD_IF_OSG(BuildOsgSimHat)},
  };
}

}  // namespace eod::bench
