#pragma once

#include <string>
#include <string_view>

namespace eod::dbc {

/// `text` as UTF-8 without a byte order mark: as it is if it is valid UTF-8, else read as
/// Windows-1252, which the usual DBC editors write.
std::string ToUtf8(std::string_view text);

}  // namespace eod::dbc
