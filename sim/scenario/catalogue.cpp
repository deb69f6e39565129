#include "sim/scenario/catalogue.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <tuple>

#include <fmt/format.h>

#include "sim/rules/toml_table.h"

namespace eod::sim {
namespace {

constexpr std::array kModules{"none", "flat", "slope", "bomb", "outdoor", "indoor"};
constexpr std::array kLights{"day", "dusk", "night"};
constexpr std::array kLinks{"ideal", "radio", "cable"};

auto SortKey(const Scenario& scenario) {
  return std::tie(scenario.module, scenario.difficulty, scenario.name);
}

std::string DescribeWeather(const Scenario& scenario) {
  std::vector<std::string_view> lights;
  for (const Weather::Light light : scenario.lights) {
    lights.emplace_back(kLights[static_cast<size_t>(light)]);
  }
  if (lights.empty()) lights.emplace_back(kLights[static_cast<size_t>(scenario.weather.light)]);
  std::string text = fmt::format("{}", fmt::join(lights, "/"));
  if (scenario.weather.visibility > 0)
    text += fmt::format(", fog {:g} m", scenario.weather.visibility);
  if (scenario.weather.rain > 0) text += fmt::format(", rain {:g} mm/h", scenario.weather.rain);
  return text;
}

std::string DescribeLink(const ControlLinkSpec& link) {
  std::string text = kLinks[static_cast<size_t>(link.kind)];
  double delay = 0;
  double loss = 0;
  for (const TrafficSpec& traffic : {link.commands, link.telemetry, link.pictures}) {
    delay = std::max(delay, traffic.delay);
    loss = std::max(loss, traffic.loss);
  }
  if (delay > 0) text += fmt::format(", {:g} ms", 1000 * delay);
  if (loss > 0) text += fmt::format(", loss {:g} %", 100 * loss);
  return text;
}

}  // namespace

std::vector<Scenario> LoadCatalogue(const std::filesystem::path& folder) {
  if (!std::filesystem::is_directory(folder)) {
    throw std::runtime_error(fmt::format("{}: no such folder of scenarios", folder.string()));
  }
  std::vector<Scenario> catalogue;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".toml") catalogue.push_back(LoadScenario(entry.path()));
  }
  // By file too, so that an error does not depend on the order of the directory.
  std::sort(catalogue.begin(), catalogue.end(), [](const Scenario& a, const Scenario& b) {
    return std::tie(a.name, a.file) < std::tie(b.name, b.file);
  });
  const auto twin =
      std::adjacent_find(catalogue.begin(), catalogue.end(),
                         [](const Scenario& a, const Scenario& b) { return a.name == b.name; });
  if (twin != catalogue.end()) {
    throw std::runtime_error(fmt::format("{}: name '{}' is that of {} too",
                                         (twin + 1)->file.string(), twin->name,
                                         twin->file.string()));
  }
  std::sort(catalogue.begin(), catalogue.end(),
            [](const Scenario& a, const Scenario& b) { return SortKey(a) < SortKey(b); });
  return catalogue;
}

const Scenario* FindScenario(std::span<const Scenario> catalogue, std::string_view name) {
  const auto found = std::find_if(catalogue.begin(), catalogue.end(),
                                  [name](const Scenario& one) { return one.name == name; });
  return found == catalogue.end() ? nullptr : &*found;
}

Scenario LoadScenario(const std::string& file_or_name, const std::filesystem::path& folder) {
  const std::filesystem::path file(file_or_name);
  if (file.has_parent_path() || file.extension() == ".toml") return LoadScenario(file);
  const std::vector<Scenario> catalogue = LoadCatalogue(folder);
  if (const Scenario* found = FindScenario(catalogue, file_or_name)) return *found;
  if (catalogue.empty()) {
    throw std::runtime_error(
        fmt::format("scenario '{}': {} has none", file_or_name, folder.string()));
  }
  std::vector<std::string_view> names;
  for (const Scenario& scenario : catalogue) names.push_back(scenario.name);
  throw std::runtime_error(fmt::format("scenario '{}' is unknown; did you mean '{}'?", file_or_name,
                                       NearestName(file_or_name, names)));
}

std::string DescribeCatalogue(std::span<const Scenario> catalogue) {
  constexpr const char* kRow = "{:<28} {:<8} {:>5} {:>5} {:<26} {:<22} {:>6}  {}\n";
  std::string text = fmt::format(fmt::runtime(kRow), "NAME", "MODULE", "LEVEL", "PAR s",
                                 "LIGHT AND AIR", "LINK", "FAULTS", "TITLE");
  for (const Scenario& scenario : catalogue) {
    text += fmt::format(fmt::runtime(kRow), scenario.name,
                        kModules[static_cast<size_t>(scenario.module)], scenario.difficulty,
                        scenario.par_time_s, DescribeWeather(scenario), DescribeLink(scenario.link),
                        scenario.faults.size(), scenario.title);
  }
  return text;
}

}  // namespace eod::sim
