#include "batch/fingerprint.h"

#include <set>

#include <fmt/format.h>

#include "batch/text_file.h"

namespace eod::batch {

void Fingerprint::Add(std::string_view bytes) {
  for (const char byte : bytes) {
    hash_ = (hash_ ^ static_cast<unsigned char>(byte)) * 0x100000001b3U;
  }
}

void Fingerprint::AddFile(const std::filesystem::path& file) { Add(ReadText(file)); }

std::string Fingerprint::text() const { return fmt::format("{:016x}", hash_); }

std::string FingerprintOf(std::string_view bytes) {
  Fingerprint fingerprint;
  fingerprint.Add(bytes);
  return fingerprint.text();
}

std::string FingerprintOfFile(const std::filesystem::path& file) {
  return FingerprintOf(ReadText(file));
}

std::string FingerprintOfSdf(const std::filesystem::path& file) {
  constexpr std::string_view kOpen = "<uri>", kClose = "</uri>";
  const std::string text = ReadText(file);
  std::set<std::string> names;
  for (size_t at = text.find(kOpen); at != std::string::npos; at = text.find(kOpen, at)) {
    at += kOpen.size();
    const size_t end = text.find(kClose, at);
    if (end == std::string::npos) break;
    names.insert(text.substr(at, end - at));
  }
  Fingerprint fingerprint;
  fingerprint.Add(text);
  for (const std::string& name : names) {
    fingerprint.Add(name);
    const std::filesystem::path named = file.parent_path() / name;
    if (std::filesystem::is_regular_file(named)) fingerprint.AddFile(named);
  }
  return fingerprint.text();
}

}  // namespace eod::batch
