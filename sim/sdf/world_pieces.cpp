#include "sim/sdf/world_pieces.h"

#include <algorithm>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

namespace eod::sim {

namespace {

struct Span {
  size_t begin = 0;
  size_t end = 0;
};

/// One piece of markup: a tag, a comment, a declaration.
struct Markup {
  enum class Kind { kOpen, kClose, kEmpty, kOther };
  Kind kind = Kind::kOther;
  std::string_view name;  ///< of a tag
  Span span;
};

/// End of a tag that begins at `begin`; a ">" between quotes does not end it.
size_t EndOfTag(std::string_view text, size_t begin) {
  char quote = 0;
  for (size_t at = begin; at < text.size(); ++at) {
    const char c = text[at];
    if (quote != 0) {
      if (c == quote) quote = 0;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '>') {
      return at + 1;
    }
  }
  return text.size();
}

std::optional<Markup> NextMarkup(std::string_view text, size_t from) {
  const size_t begin = text.find('<', from);
  if (begin == std::string_view::npos) return std::nullopt;
  for (const auto& [opening, closing] :
       {std::pair<std::string_view, std::string_view>{"<!--", "-->"},
        {"<![CDATA[", "]]>"},
        {"<?", "?>"}}) {
    if (text.substr(begin, opening.size()) != opening) continue;
    const size_t last = text.find(closing, begin + opening.size());
    const size_t end = last == std::string_view::npos ? text.size() : last + closing.size();
    return Markup{.kind = Markup::Kind::kOther, .name = {}, .span = {begin, end}};
  }
  const size_t end = EndOfTag(text, begin);
  const bool closes = text.substr(begin, 2) == "</";
  const size_t name_begin = begin + (closes ? 2 : 1);
  const size_t name_end = text.find_first_of(" \t\r\n/>", name_begin);
  Markup markup{.kind = Markup::Kind::kOpen,
                .name = text.substr(name_begin, name_end - name_begin),
                .span = {begin, end}};
  if (text[begin + 1] == '!') markup.kind = Markup::Kind::kOther;
  if (closes) markup.kind = Markup::Kind::kClose;
  if (text[end - 2] == '/') markup.kind = Markup::Kind::kEmpty;
  return markup;
}

/// What stands right in a world, <sdf>, <world>, by one of two names.
std::vector<Span> ElementSpans(std::string_view text, std::string_view name,
                               std::string_view other_name) {
  constexpr int kDepth = 2;
  std::vector<Span> spans;
  int depth = 0;
  size_t begin = 0;
  for (auto markup = NextMarkup(text, 0); markup; markup = NextMarkup(text, markup->span.end)) {
    const bool is_wanted = markup->name == name || markup->name == other_name;
    switch (markup->kind) {
      case Markup::Kind::kOpen:
        if (depth == kDepth) begin = markup->span.begin;
        ++depth;
        break;
      case Markup::Kind::kClose:
        --depth;
        if (depth == kDepth && is_wanted) spans.push_back({begin, markup->span.end});
        break;
      case Markup::Kind::kEmpty:
        if (depth == kDepth && is_wanted) spans.push_back(markup->span);
        break;
      case Markup::Kind::kOther:
        break;
    }
  }
  return spans;
}

/// The text without some spans of it; all lines keep their numbers.
std::string Without(std::string_view text, std::span<const Span> left_out) {
  std::string rest;
  size_t kept = 0;
  for (const Span& span : left_out) {
    rest += text.substr(kept, span.begin - kept);
    rest.append(
        static_cast<size_t>(std::count(text.begin() + static_cast<ptrdiff_t>(span.begin),
                                       text.begin() + static_cast<ptrdiff_t>(span.end), '\n')),
        '\n');
    kept = span.end;
  }
  return rest += text.substr(kept);
}

}  // namespace

std::vector<std::string> WorldPieces(const std::string& text, size_t model_bytes) {
  const std::vector<Span> models = ElementSpans(text, "model", "include");
  const std::vector<Span> lights = ElementSpans(text, "light", "light");
  std::vector<std::string> pieces;
  size_t first = 0;
  do {
    size_t last = first;
    size_t bytes = 0;
    while (last < models.size()) {
      bytes += models[last].end - models[last].begin;
      if (last > first && bytes > model_bytes) break;
      ++last;
    }
    std::vector<Span> others = models;
    others.erase(others.begin() + static_cast<ptrdiff_t>(first),
                 others.begin() + static_cast<ptrdiff_t>(last));
    if (first > 0) others.insert(others.end(), lights.begin(), lights.end());
    std::sort(others.begin(), others.end(),
              [](const Span& a, const Span& b) { return a.begin < b.begin; });
    pieces.push_back(Without(text, others));
    first = last;
  } while (first < models.size());
  return pieces;
}

}  // namespace eod::sim
