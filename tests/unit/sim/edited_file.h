#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

#include <unistd.h>

namespace eod::sim {

/// A copy of a data file with one place changed, beside the meshes that it names.
class EditedFile {
 public:
  explicit EditedFile(const std::filesystem::path& original)
      : folder_(std::filesystem::temp_directory_path() / ("edited_" + std::to_string(getpid()))),
        file_(folder_ / original.filename()) {
    std::filesystem::create_directories(folder_);
    std::filesystem::copy(original.parent_path() / "meshes", folder_ / "meshes",
                          std::filesystem::copy_options::recursive |
                              std::filesystem::copy_options::overwrite_existing);
    std::ifstream in(original);
    text_.assign(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
  }
  ~EditedFile() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  EditedFile(const EditedFile&) = delete;
  EditedFile& operator=(const EditedFile&) = delete;

  /// Replaces the first `from`, writes the file, and returns the start of an error message in that
  /// place: "FILE:LINE: ".
  std::string Replace(const std::string& from, const std::string& to) {
    const size_t at = text_.find(from);
    if (at == std::string::npos) throw std::runtime_error("no \"" + from + "\" to replace");
    text_.replace(at, from.size(), to);
    std::ofstream(file_) << text_;
    return PlaceOf(at);
  }

  /// "FILE:LINE: " of the first `word`.
  std::string PlaceOf(const std::string& word) const { return PlaceOf(text_.find(word)); }

  const std::filesystem::path& file() const { return file_; }

 private:
  std::string PlaceOf(size_t at) const {
    const auto line =
        1 + std::count(text_.begin(), text_.begin() + static_cast<ptrdiff_t>(at), '\n');
    return file_.string() + ":" + std::to_string(line) + ": ";
  }

  std::filesystem::path folder_, file_;
  std::string text_;
};

}  // namespace eod::sim
