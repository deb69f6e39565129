#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "recorder/canvas.h"

namespace eod::recorder {

/// Draws text of one font file.
class Typeface {
 public:
  /// Throws std::runtime_error that names the file and the package that has it.
  explicit Typeface(const std::filesystem::path& file);
  ~Typeface();
  Typeface(Typeface&&) noexcept;

  /// Width of UTF-8 `text` at `size` pixels an em.
  int Measure(std::string_view text, int size) const;
  /// Draws `text` with its left end at `x` on `baseline`; returns the x of its right end. Letters
  /// that the font lacks are drawn as its box.
  int Draw(Canvas& canvas, int x, int baseline, std::string_view text, int size,
           Colour colour) const;
  /// `text`, or as much of it as fits into `width` with an ellipsis.
  std::string Fitted(std::string_view text, int size, int width) const;

 private:
  struct Face;
  std::unique_ptr<Face> face_;
};

/// The two weights that a sheet uses: DejaVu Sans, as Debian's fonts-dejavu-core has them.
struct Typefaces {
  Typeface regular;
  Typeface bold;
};
Typefaces LoadTypefaces();

}  // namespace eod::recorder
