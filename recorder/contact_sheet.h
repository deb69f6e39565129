#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "recorder/canvas.h"
#include "recorder/moments.h"
#include "recorder/summary.h"
#include "recorder/typeface.h"

namespace eod::recorder {

inline constexpr size_t kSheetMoments = 9;

/// Where things stand on a sheet [pixel].
struct SheetLayout {
  struct Tile {
    Rectangle picture;
    Rectangle inset;  ///< the other camera, inside `picture`
    Rectangle caption;
  };
  int width = 0;
  int height = 0;
  Rectangle header;
  std::vector<Tile> tiles;  ///< in rows of three
  Rectangle footer;
};

SheetLayout LayOutSheet(size_t tiles);

/// One picture that tells the run: a title with module and result, up to nine captioned camera
/// pictures, the key numbers. Moments whose pictures are broken show an empty frame.
Picture DrawContactSheet(const Summary& summary, std::span<const Moment> moments,
                         const Typefaces& typefaces);

}  // namespace eod::recorder
