#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace eod::batch {

/// Throws std::runtime_error "FILE: cannot be read".
std::string ReadText(const std::filesystem::path& file);

/// The file is there with all of `text`, or as it was before. Throws std::runtime_error "FILE: …".
void WriteText(const std::filesystem::path& file, std::string_view text);

/// Throws std::runtime_error "FOLDER: cannot be made: …".
void MakeFolder(const std::filesystem::path& folder);

}  // namespace eod::batch
