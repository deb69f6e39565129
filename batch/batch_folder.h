#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "batch/plan.h"
#include "batch/run_record.h"
#include "batch/summary.h"

namespace eod::batch {

/// What a batch was to do, beside the runs in its folder: batch.json.
struct Manifest {
  struct Entry {
    std::string script;
    RunInputs inputs;
    bool operator==(const Entry&) const = default;
  };
  std::vector<Entry> entries;  ///< of the whole batch, in its order
  uint64_t repetitions = 0;
  Shard shard;
};

Manifest ManifestOf(const Plan& plan, const RunInputs& ground, uint64_t repetitions,
                    const Shard& shard);

// The folder of a batch: batch.json, runs/NAME.json, and at the end results.csv and summary.json.

std::filesystem::path RunsFolder(const std::filesystem::path& out);

/// Writes batch.json, and takes away the results of an earlier batch. Makes `out` if missing.
void BeginFolder(const std::filesystem::path& out, const Manifest& manifest);

/// Writes results.csv and summary.json of all its runs, sorted; gives the summary.
Summary FinishFolder(const std::filesystem::path& out, std::span<const RunRecord> sorted);

/// Puts the shards of one batch together in `out`, which then holds the same bytes as if nothing
/// had been sharded. Throws std::runtime_error that says which folder does not belong to the batch,
/// and which runs are missing.
Summary MergeFolders(std::span<const std::filesystem::path> shards,
                     const std::filesystem::path& out);

}  // namespace eod::batch
