#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "firmware_emu/condition.h"
#include "firmware_emu/manoeuvre.h"
#include "firmware_emu/panel_action.h"
#include "platform/time.h"

namespace eod::box {

/// One line of an operator script.
struct Statement {
  enum class Kind : uint8_t {
    kAction,
    kWaitFor,
    kWaitUntil,
    kHoldFor,
    kHoldUntil,
    kManoeuvre,
    kExpect,
    kNote,
    kFail
  };
  Kind kind = Kind::kNote;
  int line = 0;      ///< in the file, 1-based
  std::string text;  ///< the line as written, without leading blanks and comment
  PanelAction action;
  PanelAction press;    ///< kHold…: motions pressed, or a preset requested, when it begins
  PanelAction release;  ///< kHold…: the same let go when it ends
  Condition condition;
  Manoeuvre manoeuvre;
  Duration duration{};  ///< kWaitFor, kHoldFor: how long; …Until, kManoeuvre: at most
  std::string message;  ///< kNote, kFail
};

/// An operator script: what hands do to the box, and what eyes wait for. README.md has the format.
struct Script {
  std::filesystem::path file;
  std::vector<Statement> statements;
};

/// Throws std::runtime_error "FILE:LINE: 'WORD': allowed: …".
Script ParseScript(std::string_view text, const std::filesystem::path& file);

/// Reads a file. Throws as ParseScript, or "FILE: …" if it cannot be read.
Script LoadScript(const std::filesystem::path& file);

}  // namespace eod::box
