#include "sim/camera/glyph_atlas.h"

#include <ft2build.h>
#include FT_FREETYPE_H

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

namespace eod::sim {
namespace {

constexpr const char* kFont = "/usr/share/fonts/truetype/dejavu/DejaVuSansMono-Bold.ttf";
constexpr int kLetters = 256;
constexpr int kInkColour = 238;
constexpr int kRimColour = 10;
constexpr int kRimAlpha = 200;  // of 255

/// A font file that is open at one size.
class Face {
 public:
  explicit Face(int size) {
    if (FT_Init_FreeType(&library_) != 0) throw std::runtime_error("FreeType does not start");
    if (FT_New_Face(library_, kFont, 0, &face_) != 0) {
      FT_Done_FreeType(library_);
      throw std::runtime_error(
          fmt::format("{}: no such font: install fonts-dejavu-core, or run with --no-osd", kFont));
    }
    FT_Set_Pixel_Sizes(face_, 0, static_cast<FT_UInt>(size));
  }
  ~Face() {
    FT_Done_Face(face_);
    FT_Done_FreeType(library_);
  }
  Face(const Face&) = delete;
  Face& operator=(const Face&) = delete;

  const FT_Size_Metrics& metrics() const { return face_->size->metrics; }
  /// nullptr if the font lacks it.
  const FT_GlyphSlotRec* Load(int letter) {
    const int failed =
        FT_Load_Char(face_, static_cast<FT_ULong>(letter), FT_LOAD_RENDER | FT_LOAD_TARGET_LIGHT);
    return failed != 0 ? nullptr : face_->glyph;
  }

 private:
  FT_Library library_ = nullptr;
  FT_Face face_ = nullptr;
};

int ToPixels(FT_Pos fixed) { return static_cast<int>((fixed + 63) / 64); }

uint8_t Mix(int from, int to, int alpha) {
  return static_cast<uint8_t>(from + ((to - from) * alpha + (to > from ? 127 : -127)) / 255);
}

}  // namespace

GlyphAtlas::GlyphAtlas(int size) {
  Face face(size);
  const int ascent = ToPixels(face.metrics().ascender);
  advance_ = ToPixels(face.metrics().max_advance);
  line_height_ = ascent + ToPixels(-face.metrics().descender);
  cell_width_ = advance_ + 2 * kRim;
  cell_height_ = line_height_ + 2 * kRim;
  const auto cell = static_cast<size_t>(cell_width_ * cell_height_);
  ink_.resize(kLetters * cell);
  rim_.resize(kLetters * cell);
  for (int letter = ' ' + 1; letter < kLetters; ++letter) {
    const FT_GlyphSlotRec* glyph = face.Load(letter);
    if (glyph == nullptr) continue;
    uint8_t* ink = &ink_[static_cast<size_t>(letter) * cell];
    uint8_t* rim = &rim_[static_cast<size_t>(letter) * cell];
    const auto& bitmap = glyph->bitmap;
    for (int row = 0; row < static_cast<int>(bitmap.rows); ++row) {
      for (int column = 0; column < static_cast<int>(bitmap.width); ++column) {
        const int x = column + glyph->bitmap_left + kRim;
        const int y = row + ascent - glyph->bitmap_top + kRim;
        // Room for the rim all around; letters of this font keep to it.
        if (x < kRim || y < kRim || x >= cell_width_ - kRim || y >= cell_height_ - kRim) continue;
        const uint8_t cover = bitmap.buffer[row * bitmap.pitch + column];
        ink[y * cell_width_ + x] = cover;
        for (int dy = -1; dy <= 1; ++dy) {
          for (int dx = -1; dx <= 1; ++dx) {
            uint8_t& around = rim[(y + dy) * cell_width_ + x + dx];
            around = std::max(around, cover);
          }
        }
      }
    }
  }
}

int GlyphAtlas::Width(std::string_view text) const {
  return static_cast<int>(text.size()) * advance_ + 2 * kRim;
}

void GlyphAtlas::Draw(std::string_view text, int left, int top, const PixelView& picture) const {
  const auto cell = static_cast<size_t>(cell_width_ * cell_height_);
  int x0 = left;
  for (const char c : text) {
    const auto letter = static_cast<size_t>(static_cast<unsigned char>(c));
    const uint8_t* ink = &ink_[letter * cell];
    const uint8_t* rim = &rim_[letter * cell];
    for (int row = 0; row < cell_height_; ++row) {
      if (top + row < 0 || top + row >= picture.height) continue;
      uint8_t* line = picture.Row(top + row);
      for (int column = 0; column < cell_width_; ++column) {
        const int around = rim[row * cell_width_ + column];
        const int x = x0 + column;
        if (around == 0 || x < 0 || x >= picture.width) continue;
        uint8_t* pixel = line + 4 * static_cast<ptrdiff_t>(x);
        for (int channel = 0; channel < 3; ++channel) {
          const int shaded = Mix(pixel[channel], kRimColour, around * kRimAlpha / 255);
          pixel[channel] = Mix(shaded, kInkColour, ink[row * cell_width_ + column]);
        }
      }
    }
    x0 += advance_;
  }
}

void FillRectangle(const PixelView& picture, int left, int top, int width, int height,
                   const std::array<uint8_t, 3>& colour, int alpha) {
  const int right = std::min(left + width, picture.width);
  const int bottom = std::min(top + height, picture.height);
  for (int row = std::max(top, 0); row < bottom; ++row) {
    uint8_t* line = picture.Row(row);
    for (int x = std::max(left, 0); x < right; ++x) {
      uint8_t* pixel = line + 4 * static_cast<ptrdiff_t>(x);
      for (size_t channel = 0; channel < 3; ++channel) {
        pixel[channel] = Mix(pixel[channel], colour[channel], alpha);
      }
    }
  }
}

}  // namespace eod::sim
