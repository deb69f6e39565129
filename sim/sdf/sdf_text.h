#pragma once

#include <filesystem>
#include <string>

namespace eod::sim {

/// Reads an SDFormat file and checks that it is well-formed XML with the root <sdf>.
///
/// libsdformat forgets the lines of elements that it does not know; so each `<eod:…` start tag gets
/// an attribute `eod:line` here. Line breaks stay where they were, so libsdformat's own line
/// numbers hold. Throws std::runtime_error "FILE:LINE: …".
std::string ReadNumberedSdf(const std::filesystem::path& file);

/// Line in which `text` (as read) first has `word` between quotes or brackets; 0 if nowhere.
int LineOfWord(const std::string& text, const std::string& word);

/// Line `number` of `text` without blanks at its ends, cut to 80 characters.
std::string LineOfText(const std::string& text, int number);

}  // namespace eod::sim
