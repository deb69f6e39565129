#pragma once

namespace eod {

/// Calls of the global operator new since the program started. Linking eod_counting_new replaces
/// that operator, so it belongs into a program of its own.
long AllocationCount();

}  // namespace eod
