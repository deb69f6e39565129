#include "sim/sdf/custom_element.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace eod::sim {

namespace {

/// All of `text` as numbers with blanks between, or nothing.
std::optional<std::vector<double>> ToNumbers(std::string_view text) {
  std::vector<double> numbers;
  while (true) {
    text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
    if (text.empty()) return numbers;
    double number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{} || !std::isfinite(number)) return std::nullopt;
    numbers.push_back(number);
    text.remove_prefix(static_cast<size_t>(end - text.data()));
    if (!text.empty() && std::string_view(" \t\r\n").find(text.front()) == std::string_view::npos) {
      return std::nullopt;
    }
  }
}

std::vector<double> NumbersOf(const CustomElement& element, const std::string& attribute,
                              size_t count) {
  const std::string& text = element.Text(attribute);
  const auto numbers = ToNumbers(text);
  if (!numbers || numbers->size() != count) {
    element.Fail(fmt::format("{} = \"{}\" of <eod:{}>: needs {} number{}", attribute, text,
                             element.name, count, count == 1 ? "" : "s"));
  }
  return *numbers;
}

}  // namespace

void FailAt(const std::filesystem::path& file, int line, const std::string& text) {
  throw std::runtime_error(line > 0 ? fmt::format("{}:{}: {}", file.string(), line, text)
                                    : fmt::format("{}: {}", file.string(), text));
}

const std::string& CustomElement::Text(const std::string& attribute) const {
  const auto found = attributes.find(attribute);
  if (found == attributes.end()) {
    Fail(fmt::format("<eod:{}> needs the attribute {}", name, attribute));
  }
  return found->second;
}

double CustomElement::Number(const std::string& attribute, double lowest, double highest) const {
  const double number = NumbersOf(*this, attribute, 1)[0];
  if (number < lowest || number > highest) {
    Fail(fmt::format("{} = {} of <eod:{}>: allowed {}..{}", attribute, number, name, lowest,
                     highest));
  }
  return number;
}

int CustomElement::Integer(const std::string& attribute, int lowest, int highest) const {
  const double number = Number(attribute, lowest, highest);
  if (number != std::floor(number)) {
    Fail(fmt::format("{} = {} of <eod:{}>: needs a whole number", attribute, number, name));
  }
  return static_cast<int>(number);
}

Eigen::Vector3d CustomElement::Vector(const std::string& attribute) const {
  const std::vector<double> n = NumbersOf(*this, attribute, 3);
  return {n[0], n[1], n[2]};
}

std::vector<double> CustomElement::Numbers(const std::string& attribute) const {
  auto numbers = ToNumbers(Text(attribute));
  if (!numbers) {
    Fail(fmt::format("{} = \"{}\" of <eod:{}>: needs numbers", attribute, Text(attribute), name));
  }
  return *std::move(numbers);
}

Eigen::Isometry3d CustomElement::Pose(const std::string& attribute) const {
  const std::vector<double> n = NumbersOf(*this, attribute, 6);
  constexpr double kDegree = std::numbers::pi / 180;
  return Eigen::Translation3d(n[0], n[1], n[2]) *
         Eigen::AngleAxisd(n[5] * kDegree, Eigen::Vector3d::UnitZ()) *
         Eigen::AngleAxisd(n[4] * kDegree, Eigen::Vector3d::UnitY()) *
         Eigen::AngleAxisd(n[3] * kDegree, Eigen::Vector3d::UnitX());
}

void CustomElement::AllowAttributes(std::initializer_list<std::string_view> allowed) const {
  for (const auto& [attribute, value] : attributes) {
    if (std::find(allowed.begin(), allowed.end(), attribute) == allowed.end()) {
      Fail(fmt::format("unknown attribute {} of <eod:{}>, allowed: {}", attribute, name,
                       fmt::join(allowed, ", ")));
    }
  }
}

void AllowElements(const std::vector<CustomElement>& elements,
                   std::initializer_list<std::string_view> allowed, std::string_view where) {
  for (const CustomElement& element : elements) {
    if (std::find(allowed.begin(), allowed.end(), element.name) == allowed.end()) {
      element.Fail(allowed.size() == 0
                       ? fmt::format("unknown element <eod:{}> in {}, none is allowed here",
                                     element.name, where)
                       : fmt::format("unknown element <eod:{}> in {}, allowed: eod:{}",
                                     element.name, where, fmt::join(allowed, ", eod:")));
    }
  }
}

const CustomElement* FindElement(const std::vector<CustomElement>& elements,
                                 std::string_view name) {
  const CustomElement* found = nullptr;
  for (const CustomElement& element : elements) {
    if (element.name != name) continue;
    if (found != nullptr) {
      element.Fail(fmt::format("second <eod:{}>; the first is in line {}", name, found->line));
    }
    found = &element;
  }
  return found;
}

}  // namespace eod::sim
