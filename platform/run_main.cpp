#include "platform/run_main.h"

#include <algorithm>
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>

#include <CLI/CLI.hpp>
#include <signal.h>

namespace eod {
namespace {

enum ExitStatus { kSuccess = 0, kFailure = 1, kUsage = 2 };

std::string OnOneLine(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  std::ranges::replace(text, '\n', ' ');
  return text;
}

int ReportUsage(const CLI::App& app, const std::string& program, const CLI::ParseError& error) {
  std::cerr << program << ": " << OnOneLine(error.what()) << "\n\n" << app.help();
  return kUsage;
}

}  // namespace

int RunMain(CLI::App& app, const char* version, int argc, char** argv,
            const std::function<void()>& body) {
  // A reader that went away is an error of that one write, not the end of the program.
  ::signal(SIGPIPE, SIG_IGN);
  const std::string program = std::filesystem::path(argc > 0 ? argv[0] : "eod").filename();
  app.set_version_flag("--version", program + " " + version);
  try {
    app.parse(argc, argv);
    body();
    std::cout.flush();
    return kSuccess;
  } catch (const CLI::Success& request) {
    app.exit(request);
    return kSuccess;
  } catch (const CLI::ParseError& error) {
    return ReportUsage(app, program, error);
  } catch (const std::exception& error) {
    std::cerr << program << ": " << OnOneLine(error.what()) << std::endl;
  } catch (...) {
    std::cerr << program << ": unknown error" << std::endl;
  }
  return kFailure;
}

void SayReady(std::string_view where) { std::cout << "ready on " << where << std::endl; }

}  // namespace eod
