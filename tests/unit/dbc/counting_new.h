#pragma once

namespace eod::dbc {

/// Calls of the global operator new since the program started. Linking counting_new.cpp replaces
/// that operator, so it belongs into a program of its own.
int AllocationCount();

}  // namespace eod::dbc
