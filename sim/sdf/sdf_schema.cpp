#include "sim/sdf/sdf_schema.h"

#include <set>
#include <string_view>

#include <sdf/SDFImpl.hh>
#include <sdf/parser.hh>

namespace eod::sim {

namespace {

using Words = std::set<std::string, std::less<>>;

/// Names of all tags, and perhaps some words more.
Words TagsOf(std::string_view text) {
  Words tags;
  for (size_t at = text.find('<'); at != std::string_view::npos; at = text.find('<', at + 1)) {
    const size_t end = text.find_first_of(" \t\r\n/>", at + 1);
    tags.emplace(text.substr(at + 1, end - at - 1));
  }
  return tags;
}

bool IsWanted(const sdf::Element& element, const Words& tags) {
  const bool is_optional = element.GetRequired() == "0" || element.GetRequired() == "*";
  return !is_optional || element.GetElementDescriptionCount() == 0 ||
         tags.contains(element.GetName());
}

void CopyParameters(const sdf::Element& from, sdf::Element& to) {
  for (const sdf::ParamPtr& attribute : from.GetAttributes()) {
    to.AddAttribute(attribute->GetKey(), attribute->GetTypeName(), attribute->GetDefaultAsString(),
                    attribute->GetRequired());
  }
  if (const sdf::ParamPtr value = from.GetValue()) {
    to.AddValue(value->GetTypeName(), value->GetDefaultAsString(), value->GetRequired(),
                value->GetMinValueAsString().value_or(""),
                value->GetMaxValueAsString().value_or(""));
  }
}

sdf::ElementPtr WithoutUnwanted(const sdf::Element& element, const Words& tags) {
  auto copy = std::make_shared<sdf::Element>();
  copy->SetName(element.GetName());
  copy->SetRequired(element.GetRequired());
  copy->SetCopyChildren(element.GetCopyChildren());
  copy->SetReferenceSDF(element.ReferenceSDF());
  CopyParameters(element, *copy);
  for (unsigned i = 0; i < element.GetElementDescriptionCount(); ++i) {
    const sdf::ElementPtr child = element.GetElementDescription(i);
    if (IsWanted(*child, tags)) copy->AddElementDescription(WithoutUnwanted(*child, tags));
  }
  return copy;
}

}  // namespace

sdf::ElementPtr SchemaFor(const std::string& text) {
  const auto all = std::make_shared<sdf::SDF>();
  sdf::init(all);
  return WithoutUnwanted(*all->Root(), TagsOf(text));
}

}  // namespace eod::sim
