#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace eod::sim {

/// Cuts the text of an SDFormat world into pieces that can be read one after the other. libsdformat
/// holds a tenth of a megabyte for each <visual> of a document, so a whole world would need several
/// times the memory of all that is made of it.
///
/// Each piece is the whole document with some of the world's models (<model>, <include>) left
/// out: every model stands in exactly one piece, the lights in the first, all else in every piece,
/// and every line keeps its number. A piece holds at least one model, and more while they have no
/// more than `model_bytes` together. `text` has to be well-formed XML. A world without models is
/// one piece.
std::vector<std::string> WorldPieces(const std::string& text, size_t model_bytes);

}  // namespace eod::sim
