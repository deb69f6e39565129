#include "recorder/typeface.h"

#include <ft2build.h>
#include FT_FREETYPE_H

#include <stdexcept>
#include <vector>

#include <fmt/format.h>

namespace eod::recorder {
namespace {

constexpr char32_t kReplacement = 0xFFFD;

// Code points of UTF-8 text; what is not UTF-8 becomes the replacement sign.
std::vector<char32_t> CodePoints(std::string_view text) {
  std::vector<char32_t> points;
  int more = 0;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (more > 0 && (byte & 0xC0U) == 0x80U) {
      points.back() = points.back() << 6 | (byte & 0x3FU);
      --more;
      continue;
    }
    if (more > 0) points.back() = kReplacement;
    more = byte < 0xC0 ? 0 : byte < 0xE0 ? 1 : byte < 0xF0 ? 2 : 3;
    const auto lead = static_cast<char32_t>(more == 0 ? byte : byte & (0x3FU >> more));
    points.push_back(more == 0 && byte >= 0x80 ? kReplacement : lead);
  }
  if (more > 0) points.back() = kReplacement;
  return points;
}

}  // namespace

struct Typeface::Face {
  FT_Library library = nullptr;
  FT_Face face = nullptr;

  ~Face() {
    if (face != nullptr) FT_Done_Face(face);
    if (library != nullptr) FT_Done_FreeType(library);
  }

  // Walks along the text; `visit(glyph, x)` with the pen in 1/64 pixel. Returns the final pen.
  template <typename Visit>
  FT_Pos Walk(std::string_view text, int size, FT_Int32 flags, Visit visit) {
    FT_Set_Pixel_Sizes(face, 0, static_cast<FT_UInt>(size));
    FT_Pos pen = 0;
    FT_UInt previous = 0;
    for (const char32_t point : CodePoints(text)) {
      const FT_UInt index = FT_Get_Char_Index(face, point);
      FT_Vector kerning{};
      if (previous != 0) FT_Get_Kerning(face, previous, index, FT_KERNING_DEFAULT, &kerning);
      if (FT_Load_Glyph(face, index, flags | FT_LOAD_TARGET_LIGHT) != 0) continue;
      pen += kerning.x;
      visit(*face->glyph, pen);
      pen += face->glyph->advance.x;
      previous = index;
    }
    return pen;
  }
};

Typeface::Typeface(const std::filesystem::path& file) : face_(std::make_unique<Face>()) {
  if (FT_Init_FreeType(&face_->library) != 0) throw std::runtime_error("FreeType does not start");
  if (FT_New_Face(face_->library, file.c_str(), 0, &face_->face) != 0) {
    throw std::runtime_error(
        fmt::format("{}: no such font: apt-get install fonts-dejavu-core", file.string()));
  }
}

Typeface::~Typeface() = default;
Typeface::Typeface(Typeface&&) noexcept = default;

int Typeface::Measure(std::string_view text, int size) const {
  const auto ignore = [](const FT_GlyphSlotRec&, FT_Pos) {};
  return static_cast<int>((face_->Walk(text, size, FT_LOAD_DEFAULT, ignore) + 63) / 64);
}

int Typeface::Draw(Canvas& canvas, int x, int baseline, std::string_view text, int size,
                   Colour colour) const {
  const auto draw = [&](const FT_GlyphSlotRec& glyph, FT_Pos pen) {
    const FT_Bitmap& bitmap = glyph.bitmap;
    const int left = x + static_cast<int>((pen + 32) / 64) + glyph.bitmap_left;
    const int top = baseline - glyph.bitmap_top;
    for (int row = 0; row < static_cast<int>(bitmap.rows); ++row) {
      for (int column = 0; column < static_cast<int>(bitmap.width); ++column) {
        canvas.Blend(left + column, top + row, colour, bitmap.buffer[row * bitmap.pitch + column]);
      }
    }
  };
  return x + static_cast<int>((face_->Walk(text, size, FT_LOAD_RENDER, draw) + 63) / 64);
}

std::string Typeface::Fitted(std::string_view text, int size, int width) const {
  if (Measure(text, size) <= width) return std::string(text);
  std::string_view head = text;
  while (!head.empty()) {
    // A whole character goes, not a byte of one.
    size_t length = head.size() - 1;
    while (length > 0 && (static_cast<unsigned char>(head[length]) & 0xC0U) == 0x80U) --length;
    head = head.substr(0, length);
    std::string shortened = std::string(head) + "…";
    if (Measure(shortened, size) <= width) return shortened;
  }
  return "";
}

Typefaces LoadTypefaces() {
  const std::filesystem::path folder = "/usr/share/fonts/truetype/dejavu";
  return {Typeface(folder / "DejaVuSans.ttf"), Typeface(folder / "DejaVuSans-Bold.ttf")};
}

}  // namespace eod::recorder
