#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "sim/segments/segment.h"
#include "tests/bench/isector_bench/indexed_mesh.h"
#include "tests/bench/isector_bench/scene.h"

namespace eod::bench {

/// Something that answers segments, with whatever it keeps for one robot in one thread.
class Engine {
 public:
  virtual ~Engine() = default;
  /// The lines of one frame; both spans have one length. Fills at least hit, range and point.
  virtual void Cast(std::span<const sim::SegmentQuery> lines, std::span<sim::SegmentHit> hits) = 0;
};

/// What an engine is built from, ready before the clock of the build starts. The engine keeps what
/// it needs of it; both may be dropped afterwards.
struct Source {
  const Scene& scene;
  const IndexedMesh& mesh;
};

struct EngineSpec {
  std::string name;
  std::string package = {};            ///< Debian package that brings it; "" for the product itself
  int64_t most_triangles = 100000000;  ///< beyond this it is skipped
  bool legs_only = false;              ///< has heights over ground only, so TRIPOD alone is asked
  std::unique_ptr<Engine> (*build)(const Source& source) = nullptr;  ///< null: not installed
};

/// All engines, installed or not, in the order of the report.
std::vector<EngineSpec> KnownEngines();

std::unique_ptr<Engine> BuildOurs(const Source& source);
/// As on a processor with nothing beyond plain x86-64.
std::unique_ptr<Engine> BuildOursPlain(const Source& source);
std::unique_ptr<Engine> BuildBullet(const Source& source);
std::unique_ptr<Engine> BuildEmbree(const Source& source);
/// With RTC_SCENE_FLAG_ROBUST: does not leak at edges.
std::unique_ptr<Engine> BuildEmbreeRobust(const Source& source);
std::unique_ptr<Engine> BuildOsg(const Source& source);
std::unique_ptr<Engine> BuildOsgSimHat(const Source& source);
std::unique_ptr<Engine> BuildOsgSimLos(const Source& source);

}  // namespace eod::bench
