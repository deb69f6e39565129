#include "sim/geometry/obj_file.h"

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

#include <fmt/format.h>

namespace eod::sim {

namespace {

/// Corner number of a face, "7", "7/1" or "7//3": counted from 1, or from the end if negative.
size_t CornerIndex(const std::string& word, size_t count) {
  const long number = std::stol(word);
  const long index = number < 0 ? static_cast<long>(count) + number : number - 1;
  if (number == 0 || index < 0 || index >= static_cast<long>(count)) {
    throw std::out_of_range(fmt::format("corner {} of {}", number, count));
  }
  return static_cast<size_t>(index);
}

void ReadObjLine(const std::string& line, std::vector<Eigen::Vector3d>& corners, Mesh& mesh) {
  std::istringstream words(line);
  std::string kind;
  words >> kind;
  if (kind == "v") {
    Eigen::Vector3d corner;
    if (!(words >> corner.x() >> corner.y() >> corner.z())) {
      throw std::invalid_argument("needs three numbers");
    }
    corners.push_back(corner);
  } else if (kind == "f") {
    std::vector<size_t> face;
    for (std::string word; words >> word;) face.push_back(CornerIndex(word, corners.size()));
    if (face.size() < 3) throw std::invalid_argument("needs three corners or more");
    for (size_t i = 2; i < face.size(); ++i) {
      mesh.push_back({corners[face[0]], corners[face[i - 1]], corners[face[i]]});
    }
  }
}

}  // namespace

Mesh ReadObj(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error(fmt::format("{}: cannot be read", file.string()));
  std::vector<Eigen::Vector3d> corners;
  Mesh mesh;
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) {
    try {
      ReadObjLine(line, corners, mesh);
    } catch (const std::exception& error) {
      throw std::runtime_error(
          fmt::format("{}:{}: bad line \"{}\": {}", file.string(), number, line, error.what()));
    }
  }
  if (mesh.empty()) throw std::runtime_error(fmt::format("{}: has no faces", file.string()));
  return mesh;
}

}  // namespace eod::sim
