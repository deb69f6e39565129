#include "sim/score/report.h"

#include <fstream>
#include <stdexcept>
#include <string>

#include <fmt/format.h>

#include "sim/score/score_json.h"
#include "sim/score/score_page.h"

namespace eod::sim {
namespace {

namespace fs = std::filesystem;

void WriteWhole(const fs::path& file, const std::string& text) {
  fs::path part = file;
  part += ".part";
  std::ofstream out(part, std::ios::binary);
  out << text;
  out.close();
  std::error_code failure;
  if (out) fs::rename(part, file, failure);
  if (!out || failure) {
    std::error_code ignored;
    fs::remove(part, ignored);
    throw std::runtime_error(fmt::format("{}: cannot be written", file.string()));
  }
}

}  // namespace

void WriteReport(const ScoreSheet& sheet, const fs::path& folder) {
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (failure) {
    throw std::runtime_error(
        fmt::format("{}: cannot be made: {}", folder.string(), failure.message()));
  }
  WriteWhole(folder / "score.json", ToJson(sheet));
  WriteWhole(folder / "report.html", ToPage(sheet));
}

}  // namespace eod::sim
