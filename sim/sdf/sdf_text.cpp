#include "sim/sdf/sdf_text.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <sstream>

#include <fmt/format.h>
#include <tinyxml2.h>

#include "sim/sdf/custom_element.h"

namespace eod::sim {

namespace {

void CheckXml(const std::filesystem::path& file, const std::string& text) {
  tinyxml2::XMLDocument document;
  if (document.Parse(text.data(), text.size()) != tinyxml2::XML_SUCCESS) {
    std::string kind = document.ErrorName();
    if (kind.starts_with("XML_")) kind.erase(0, 4);
    FailAt(file, document.ErrorLineNum(), fmt::format("broken XML ({})", kind));
  }
  const tinyxml2::XMLElement* root = document.RootElement();
  if (root == nullptr || std::string_view(root->Name()) != "sdf") {
    FailAt(file, root == nullptr ? 1 : root->GetLineNum(), "root element is not <sdf>");
  }
}

}  // namespace

std::string ReadNumberedSdf(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in || std::filesystem::is_directory(file)) FailAt(file, 0, "cannot be read");
  const std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  CheckXml(file, text);

  constexpr std::string_view kTag = "<eod:";
  std::string numbered;
  size_t copied = 0;
  int line = 1;
  for (size_t at = text.find(kTag); at != std::string::npos; at = text.find(kTag, at + 1)) {
    line += static_cast<int>(std::count(text.begin() + static_cast<ptrdiff_t>(copied),
                                        text.begin() + static_cast<ptrdiff_t>(at), '\n'));
    const size_t name_end = text.find_first_of(" \t\r\n/>", at);
    numbered.append(text, copied, name_end - copied);
    numbered += fmt::format(" eod:line=\"{}\"", line);
    copied = name_end;
  }
  return numbered.append(text, copied);
}

int LineOfWord(const std::string& text, const std::string& word) {
  for (const std::string& quoted : {'"' + word + '"', '>' + word + '<'}) {
    const size_t at = text.find(quoted);
    if (at == std::string::npos) continue;
    return 1 + static_cast<int>(
                   std::count(text.begin(), text.begin() + static_cast<ptrdiff_t>(at), '\n'));
  }
  return 0;
}

std::string LineOfText(const std::string& text, int number) {
  std::istringstream in(text);
  std::string line;
  for (int i = 0; i < number && std::getline(in, line); ++i) {
  }
  const size_t begin = std::min(line.find_first_not_of(" \t\r"), line.size());
  line.erase(0, begin);
  line.erase(line.find_last_not_of(" \t\r") + 1);
  return line.size() > 80 ? line.substr(0, 77) + "..." : line;
}

}  // namespace eod::sim
