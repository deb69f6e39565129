#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "sim/scenario/scenario.h"

namespace eod::sim {

/// The exercises of a folder: all its *.toml, sorted by module, difficulty and name. Throws
/// std::runtime_error with one line "FILE:LINE: …" for a file that is no scenario, "FILE: …" for a
/// name that two files give, and for a folder that is not there.
std::vector<Scenario> LoadCatalogue(const std::filesystem::path& folder);

/// The exercise of that name, or nullptr.
const Scenario* FindScenario(std::span<const Scenario> catalogue, std::string_view name);

/// A scenario by its file, or by its name in the folder `catalogue`. What ends in ".toml" or names
/// a folder is a file. Throws what LoadScenario and LoadCatalogue throw; for an unknown name it
/// names the nearest one.
Scenario LoadScenario(const std::string& file_or_name, const std::filesystem::path& catalogue);

/// A table for people: a line for each scenario under a heading.
std::string DescribeCatalogue(std::span<const Scenario> catalogue);

}  // namespace eod::sim
