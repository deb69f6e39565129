#include "sim/world/world_model.h"
#include "tests/bench/isector_bench/engine.h"

namespace eod::bench {

namespace {

/// As the product builds it: with the best instruction set of this processor, or with plain x86-64
/// alone.
std::unique_ptr<sim::World> BuildProduct(const sim::ModuleModel& module, bool plain) {
  return sim::BuildWorld(module, plain ? sim::InstructionSet::kPlain : sim::BestInstructionSet());
}

class Ours final : public Engine {
 public:
  Ours(const Source& source, bool plain) : world_(BuildProduct(source.scene.module, plain)) {}

  void Cast(std::span<const sim::SegmentQuery> lines, std::span<sim::SegmentHit> hits) override {
    world_->Cast(lines, hits, memory_);
  }

 private:
  std::unique_ptr<sim::World> world_;
  sim::CastMemory memory_;
};

}  // namespace

std::unique_ptr<Engine> BuildOurs(const Source& source) {
  return std::make_unique<Ours>(source, false);
}

std::unique_ptr<Engine> BuildOursPlain(const Source& source) {
  return std::make_unique<Ours>(source, true);
}

}  // namespace eod::bench
