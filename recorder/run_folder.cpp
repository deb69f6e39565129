#include "recorder/run_folder.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>

#include <fmt/format.h>

namespace eod::recorder {
namespace fs = std::filesystem;
namespace {

std::runtime_error Refusal(const fs::path& folder, const std::string& reason) {
  return std::runtime_error(
      fmt::format("--out {}: {}: name a folder that can be written", folder.string(), reason));
}

}  // namespace

RunFolder::RunFolder(const fs::path& folder) : folder_(folder) {
  std::error_code failure;
  fs::create_directories(folder_ / "camera", failure);
  if (failure) throw Refusal(folder_, failure.message());
  const fs::path probe = folder_ / "probe.part";
  std::ofstream(probe) << '.';
  if (!fs::remove(probe, failure)) throw Refusal(folder_, "it cannot be written");
}

void RunFolder::RemoveEarlierRun() const {
  try {
    for (const fs::path& file : {can_log(), lcm_log(), summary(), contact_sheet()}) {
      fs::remove(file);
    }
    for (const auto& entry : fs::directory_iterator(folder_ / "camera")) {
      if (entry.path().extension() == ".jpg") fs::remove(entry.path());
    }
  } catch (const fs::filesystem_error& error) {
    throw Refusal(folder_, error.code().message());
  }
}

fs::path RunFolder::picture(double t, std::string_view camera) const {
  return folder_ / "camera" / fmt::format("{:08.3f}-{}.jpg", t, camera);
}

void WriteWhole(const fs::path& file, std::span<const uint8_t> bytes) {
  const fs::path temporary = file.string() + ".part";
  errno = 0;
  std::ofstream out(temporary, std::ios::binary | std::ios::trunc);
  out.write(reinterpret_cast<const char*>(bytes.data()),
            static_cast<std::streamsize>(bytes.size()));
  out.close();
  std::error_code failure;
  if (out) fs::rename(temporary, file, failure);
  if (!out || failure) {
    const std::string reason = failure ? failure.message() : std::strerror(errno);
    fs::remove(temporary, failure);
    throw std::runtime_error(fmt::format("{}: {}", file.string(), reason));
  }
}

void WriteWhole(const fs::path& file, std::string_view text) {
  WriteWhole(file, {reinterpret_cast<const uint8_t*>(text.data()), text.size()});
}

}  // namespace eod::recorder
