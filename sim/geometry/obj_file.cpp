#include "sim/geometry/obj_file.h"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

namespace eod::sim {

namespace {

/// Takes the first word off a line; empty at its end.
std::string_view NextWord(std::string_view& line) {
  constexpr std::string_view kBlanks = " \t\r\v\f";
  const size_t begin = std::min(line.find_first_not_of(kBlanks), line.size());
  const size_t end = std::min(line.find_first_of(kBlanks, begin), line.size());
  const std::string_view word = line.substr(begin, end - begin);
  line.remove_prefix(end);
  return word;
}

/// The number that a word begins with. Worlds have a hundred thousand of them: no streams.
template <typename Number>
Number NumberOf(std::string_view word, const char* wanted) {
  Number number{};
  if (word.starts_with('+')) word.remove_prefix(1);
  const auto result = std::from_chars(word.data(), word.data() + word.size(), number);
  if (result.ec != std::errc()) throw std::invalid_argument(wanted);
  return number;
}

/// Corner number of a face, "7", "7/1" or "7//3": counted from 1, or from the end if negative.
size_t CornerIndex(std::string_view word, size_t count) {
  const long number = NumberOf<long>(word, "needs corner numbers");
  const long index = number < 0 ? static_cast<long>(count) + number : number - 1;
  if (number == 0 || index < 0 || index >= static_cast<long>(count)) {
    throw std::out_of_range(fmt::format("corner {} of {}", number, count));
  }
  return static_cast<size_t>(index);
}

void ReadObjLine(std::string_view line, std::vector<Eigen::Vector3d>& corners,
                 std::vector<size_t>& face, Mesh& mesh) {
  const std::string_view kind = NextWord(line);
  if (kind == "v") {
    Eigen::Vector3d corner;
    for (double& length : corner) length = NumberOf<double>(NextWord(line), "needs three numbers");
    corners.push_back(corner);
  } else if (kind == "f") {
    face.clear();
    for (std::string_view word = NextWord(line); !word.empty(); word = NextWord(line)) {
      face.push_back(CornerIndex(word, corners.size()));
    }
    if (face.size() < 3) throw std::invalid_argument("needs three corners or more");
    for (size_t i = 2; i < face.size(); ++i) {
      mesh.push_back({corners[face[0]], corners[face[i - 1]], corners[face[i]]});
    }
  }
}

}  // namespace

Mesh ReadObj(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw std::runtime_error(fmt::format("{}: cannot be read", file.string()));
  std::string text(std::filesystem::file_size(file), '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  std::vector<Eigen::Vector3d> corners;
  std::vector<size_t> face;
  Mesh mesh;
  std::string_view rest = text;
  for (int number = 1; !rest.empty(); ++number) {
    const size_t end = std::min(rest.find('\n'), rest.size());
    const std::string_view line = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    try {
      ReadObjLine(line, corners, face, mesh);
    } catch (const std::exception& error) {
      throw std::runtime_error(
          fmt::format("{}:{}: bad line \"{}\": {}", file.string(), number, line, error.what()));
    }
  }
  if (mesh.empty()) throw std::runtime_error(fmt::format("{}: has no faces", file.string()));
  return mesh;
}

}  // namespace eod::sim
