#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace eod::recorder {

/// The folder of one run and the names in it.
class RunFolder {
 public:
  /// Makes the folder if needed. Throws std::runtime_error with one line if it cannot be made or
  /// written.
  explicit RunFolder(const std::filesystem::path& folder);

  /// Removes what an earlier run left under the names below, so that runs do not mix. Throws as the
  /// constructor does.
  void RemoveEarlierRun() const;

  std::filesystem::path can_log() const { return folder_ / "can.log"; }
  std::filesystem::path lcm_log() const { return folder_ / "run.lcmlog"; }
  std::filesystem::path summary() const { return folder_ / "summary.json"; }
  std::filesystem::path contact_sheet() const { return folder_ / "contact_sheet.png"; }
  /// `camera/0012.345-drive.jpg`: sorts by time.
  std::filesystem::path picture(double t, std::string_view camera) const;

  const std::filesystem::path& path() const { return folder_; }

 private:
  std::filesystem::path folder_;
};

/// Writes the whole file or nothing: into a temporary beside it, then renamed. Throws
/// std::runtime_error naming the file and the reason.
void WriteWhole(const std::filesystem::path& file, std::span<const uint8_t> bytes);
void WriteWhole(const std::filesystem::path& file, std::string_view text);

}  // namespace eod::recorder
