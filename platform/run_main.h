#pragma once

#include <functional>
#include <string_view>

#include <CLI/App.hpp>

namespace eod {

/// Parses the command line with `app`, then runs `body`.
///
/// Returns the exit status: 0; 1 after an exception, whose text is printed as one line
/// "PROGRAM: TEXT" on stderr; 2 after bad arguments, with the reason and the usage on stderr.
/// `--help` and `--version` (of `version`) print and give 0.
int RunMain(CLI::App& app, const char* version, int argc, char** argv,
            const std::function<void()>& body);

/// Tells whoever started this program, in one line on stdout, that it works now: "ready on WHERE".
void SayReady(std::string_view where);

}  // namespace eod
