#pragma once

#include "sim/camera/canvas.h"

namespace eod::sim {

// Painters of what a street is made of, one tile each; the same bits in every run. The tile's usual
// size stands behind each.

Canvas PaintGravel();      ///< 1.5 m: loose stones
Canvas PaintPaving();      ///< 1.2 m: three by three slabs
Canvas PaintRender();      ///< 3 m: rendered wall with rain stains
Canvas PaintRooftile();    ///< 1.5 m: six courses of pantiles, eaves below
Canvas PaintWindows();     ///< 6 m: rendered wall, two storeys of two windows each
Canvas PaintShopwindow();  ///< 2 m: goods on boards behind glass
Canvas PaintFruit();       ///< 0.5 m: round fruit in a heap, white for any colour
Canvas PaintLeaves();      ///< 0.8 m: clipped hedge

}  // namespace eod::sim
