#pragma once

#include <string>

#include <sdf/Element.hh>

namespace eod::sim {

/// What libsdformat knows of its format, as the root to read into, for documents whose tags all
/// occur in `text`. Left out are optional elements with elements of their own that no tag there
/// names, such as <pbr> or <heightmap>: libsdformat copies all that could stand in an element into
/// each one that it reads, which takes most of its time.
sdf::ElementPtr SchemaFor(const std::string& text);

}  // namespace eod::sim
