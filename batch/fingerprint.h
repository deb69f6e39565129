#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace eod::batch {

/// Tells contents apart: FNV-1a of 64 bits (Fowler, Noll, Vo), as 16 hexadecimal digits.
class Fingerprint {
 public:
  void Add(std::string_view bytes);
  /// Throws std::runtime_error "FILE: …" if it cannot be read.
  void AddFile(const std::filesystem::path& file);
  std::string text() const;

 private:
  uint64_t hash_ = 0xcbf29ce484222325U;
};

std::string FingerprintOf(std::string_view bytes);
std::string FingerprintOfFile(const std::filesystem::path& file);

/// Of an SDFormat file and of every file that a <uri> in it names.
std::string FingerprintOfSdf(const std::filesystem::path& file);

}  // namespace eod::batch
