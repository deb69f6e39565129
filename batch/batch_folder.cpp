#include "batch/batch_folder.h"

#include <optional>
#include <stdexcept>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "batch/text_file.h"

namespace eod::batch {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

fs::path ManifestFile(const fs::path& out) { return out / "batch.json"; }

std::string ToJson(const Manifest& manifest) {
  Json entries = Json::array();
  for (const Manifest::Entry& entry : manifest.entries) {
    entries.push_back({{"script", entry.script}, {"inputs", ToJsonValue(entry.inputs)}});
  }
  const Json json = {{"repetitions", manifest.repetitions},
                     {"shard", {manifest.shard.index, manifest.shard.count}},
                     {"scripts", entries}};
  return json.dump(2) + "\n";
}

Manifest ReadManifest(const fs::path& out) {
  const fs::path file = ManifestFile(out);
  const std::string text = ReadText(file);
  try {
    const Json json = Json::parse(text);
    Manifest manifest;
    manifest.repetitions = json.at("repetitions");
    manifest.shard = {.index = json.at("shard").at(0), .count = json.at("shard").at(1)};
    for (const Json& entry : json.at("scripts")) {
      manifest.entries.push_back(
          {.script = entry.at("script"), .inputs = InputsOf(entry.at("inputs"))});
    }
    return manifest;
  } catch (const Json::exception& error) {
    throw std::runtime_error(fmt::format("{}: is of no batch: {}", file.string(), error.what()));
  }
}

/// All shards' manifests must say the same; gives it, for all of them.
Manifest CommonManifest(std::span<const fs::path> shards) {
  std::optional<Manifest> common;
  for (const fs::path& shard : shards) {
    const Manifest manifest = ReadManifest(shard);
    if (!common) {
      common = manifest;
    } else if (manifest.entries != common->entries || manifest.repetitions != common->repetitions) {
      throw std::runtime_error(
          fmt::format("{}: is of another batch than {}: scripts, repetitions, files or program "
                      "differ",
                      shard.string(), shards.front().string()));
    }
  }
  if (!common) throw std::runtime_error("nothing to merge");
  common->shard = {};
  return *common;
}

/// The file of that run in one of the shards, of the inputs it is to have; "" if there is none.
fs::path FindRun(std::span<const fs::path> shards, const std::string& name,
                 const RunInputs& inputs) {
  for (const fs::path& shard : shards) {
    const fs::path file = RunsFolder(shard) / name;
    if (fs::exists(file) && ReadRecord(file).inputs == inputs) return file;
  }
  return {};
}

}  // namespace

Manifest ManifestOf(const Plan& plan, const RunInputs& ground, uint64_t repetitions,
                    const Shard& shard) {
  Manifest manifest{.entries = {}, .repetitions = repetitions, .shard = shard};
  for (const Pair& pair : plan.pairs) {
    RunInputs inputs = ground;
    inputs.scenario = pair.scenario_print;
    inputs.script = pair.script_print;
    manifest.entries.push_back({.script = pair.script_name, .inputs = inputs});
  }
  return manifest;
}

fs::path RunsFolder(const fs::path& out) { return out / "runs"; }

void BeginFolder(const fs::path& out, const Manifest& manifest) {
  MakeFolder(RunsFolder(out));
  for (const char* name : {"results.csv", "summary.json"}) fs::remove(out / name);
  WriteText(ManifestFile(out), ToJson(manifest));
}

Summary FinishFolder(const fs::path& out, std::span<const RunRecord> sorted) {
  const Summary summary = Summarise(sorted);
  WriteText(out / "results.csv", ToCsv(sorted));
  WriteText(out / "summary.json", ToJson(summary));
  return summary;
}

Summary MergeFolders(std::span<const fs::path> shards, const fs::path& out) {
  const Manifest manifest = CommonManifest(shards);
  std::vector<fs::path> files;
  size_t missing = 0;
  std::string first_missing;
  for (const Manifest::Entry& entry : manifest.entries) {
    for (uint64_t repetition = 0; repetition < manifest.repetitions; ++repetition) {
      const std::string name = RunName(entry.script, repetition) + ".json";
      files.push_back(FindRun(shards, name, entry.inputs));
      if (files.back().empty() && missing++ == 0) first_missing = name;
    }
  }
  if (missing > 0) {
    throw std::runtime_error(fmt::format(
        "{} of {} runs are missing, the first is {}: has every shard been run to its end?", missing,
        files.size(), first_missing));
  }
  BeginFolder(out, manifest);
  std::vector<RunRecord> records;
  for (const fs::path& file : files) {
    records.push_back(ReadRecord(file));
    const fs::path merged = RunsFolder(out) / file.filename();
    if (!fs::exists(merged) || !fs::equivalent(file, merged)) WriteText(merged, ReadText(file));
  }
  SortRecords(records);
  return FinishFolder(out, records);
}

}  // namespace eod::batch
