#include "batch/text_file.h"

#include <fstream>
#include <stdexcept>

#include <fmt/format.h>

namespace eod::batch {

namespace fs = std::filesystem;

std::string ReadText(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::error_code failure;
  const uintmax_t size = fs::file_size(file, failure);
  std::string text(failure ? 0 : size, '\0');
  if (!failure) in.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (failure || !in) throw std::runtime_error(fmt::format("{}: cannot be read", file.string()));
  return text;
}

void WriteText(const fs::path& file, std::string_view text) {
  fs::path pending = file;
  pending += ".part";
  std::ofstream out(pending, std::ios::binary);
  out.write(text.data(), static_cast<std::streamsize>(text.size()));
  out.close();
  std::error_code failure;
  if (out) fs::rename(pending, file, failure);
  if (!out || failure) {
    fs::remove(pending, failure);
    throw std::runtime_error(fmt::format("{}: cannot be written", file.string()));
  }
}

void MakeFolder(const fs::path& folder) {
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (failure) {
    throw std::runtime_error(
        fmt::format("{}: cannot be made: {}", folder.string(), failure.message()));
  }
}

}  // namespace eod::batch
