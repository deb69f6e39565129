#pragma once

#include "sim/camera/canvas.h"

namespace eod::sim {

/// One tile each of what is found inside buildings; see PaintSurfaceTexture.
Canvas PaintPlaster();
Canvas PaintCarpet();
Canvas PaintTile();     ///< 2 x 2 floor tiles
Canvas PaintCeiling();  ///< 2 x 2 panels of mineral fibre in a light frame
Canvas PaintBooks();    ///< two rows of backs of books and files; v = 0 and 0.5 are boards
Canvas PaintRack();     ///< units of a server rack with their lamps

}  // namespace eod::sim
