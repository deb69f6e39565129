// Runs a mission in lock-step and writes pictures of chosen moments as one PNG, for the documents.
#include <fstream>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "recorder/image_codec.h"
#include "recorder/typeface.h"
#include "sim/score/report.h"
#include "tests/scenario/mission.h"
#include "tests/unit/camera/conditions.h"
#include "tests/unit/camera/offline_camera.h"

namespace eod {
namespace {

constexpr int kTileWidth = 480, kTileHeight = 360, kCaption = 34, kGap = 6;
constexpr recorder::Colour kPaper{24, 26, 28}, kInk{232, 232, 228};

/// A picture to take: "SECONDS:CAMERA:CAPTION".
struct Moment {
  double seconds = 0;
  std::string camera;
  std::string caption;
};

struct Options {
  std::string scenario;
  std::string script;
  std::string output = "strip.png";
  std::vector<std::string> moments;
  std::string states;   // file for the states of every step; none if empty
  std::string report;   // folder for the score; none if empty
  std::string weather;  // as the scenario has it if empty
  int columns = 3;
};

Moment ParseMoment(const std::string& text) {
  const size_t first = text.find(':'), second = text.find(':', first + 1);
  if (first == std::string::npos || second == std::string::npos) {
    throw std::runtime_error(fmt::format("--at '{}': SECONDS:CAMERA:CAPTION", text));
  }
  return {.seconds = std::stod(text.substr(0, first)),
          .camera = text.substr(first + 1, second - first - 1),
          .caption = text.substr(second + 1)};
}

recorder::Picture ToPicture(const sim::OfflineCamera& camera, const std::vector<uint8_t>& rgba) {
  const int width = camera.width(), height = camera.height();
  recorder::Picture picture{.width = width, .height = height, .rgb = {}};
  picture.rgb.reserve(static_cast<size_t>(3 * width * height));
  for (int y = height - 1; y >= 0; --y) {  // the bottom row comes first
    for (int x = 0; x < width; ++x) {
      const auto at = static_cast<size_t>(4 * (y * width + x));
      picture.rgb.insert(picture.rgb.end(), {rgba[at], rgba[at + 1], rgba[at + 2]});
    }
  }
  return picture;
}

void DrawTile(const recorder::Picture& picture, const Moment& moment, size_t index, int columns,
              const recorder::Typefaces& faces, recorder::Canvas& sheet) {
  const int column = static_cast<int>(index) % columns, row = static_cast<int>(index) / columns;
  const int x = kGap + column * (kTileWidth + kGap);
  const int y = kGap + row * (kTileHeight + kCaption + kGap);
  sheet.Place(picture, {.x = x, .y = y, .width = kTileWidth, .height = kTileHeight});
  const std::string text = faces.regular.Fitted(
      fmt::format("{:.1f} s  {}", moment.seconds, moment.caption), 19, kTileWidth - 2 * kGap);
  faces.regular.Draw(sheet, x + kGap, y + kTileHeight + 24, text, 19, kInk);
}

void Run(const Options& options) {
  std::vector<Moment> moments;
  for (const std::string& text : options.moments) moments.push_back(ParseMoment(text));
  lockstep::Mission mission(box::LoadScript(options.script),
                            lockstep::ShippedScenario(options.scenario));
  sim::SceneSnapshot scene;
  mission.rig().SetSceneOutput({.show = [&scene](const auto& shown) { scene = shown; },
                                .period = std::chrono::milliseconds(4)});
  const lockstep::Shipped& shipped = lockstep::ShippedData();
  sim::OfflineCamera camera(shipped.robot, shipped.world);
  const recorder::Typefaces faces = recorder::LoadTypefaces();
  const int count = static_cast<int>(moments.size());
  const int rows = (count + options.columns - 1) / options.columns;
  recorder::Canvas sheet(kGap + options.columns * (kTileWidth + kGap),
                         kGap + rows * (kTileHeight + kCaption + kGap), kPaper);
  const TimePoint start = mission.rig().now();
  for (size_t i = 0; i < moments.size(); ++i) {
    while (ToSeconds(mission.rig().now() - start) < moments[i].seconds) mission.Tick();
    if (!options.weather.empty()) scene.weather = sim::ParseWeather(options.weather);
    DrawTile(ToPicture(camera, camera.Take(scene, moments[i].camera)), moments[i], i,
             options.columns, faces, sheet);
  }
  const std::vector<uint8_t> png = recorder::EncodePng(sheet.picture());
  std::ofstream(options.output, std::ios::binary)
      .write(reinterpret_cast<const char*>(png.data()), static_cast<std::streamsize>(png.size()));
  mission.Run(std::chrono::minutes(30));
  if (!options.states.empty()) std::ofstream(options.states) << mission.states();
  if (!options.report.empty()) {
    sim::WriteReport(mission.rig().simulator().scorer().Sheet(), options.report);
  }
  if (mission.box().script_failure()) fmt::print("{}\n", *mission.box().script_failure());
  fmt::print("{}: {} pictures, {} bytes\n", options.output, count, png.size());
}

}  // namespace
}  // namespace eod

int main(int argc, char** argv) {
  eod::Options options;
  CLI::App app("Runs a mission in lock-step and writes pictures of it as one PNG");
  app.add_option("--scenario", options.scenario, "name of a shipped one")->required();
  app.add_option("--script", options.script, "operator script")->required();
  app.add_option("--at", options.moments, "SECONDS:CAMERA:CAPTION, in the order of time")
      ->required();
  app.add_option("--states", options.states, "write every state of the run there, as CSV");
  app.add_option("--report", options.report, "write the score of the run into this folder");
  app.add_option("--weather", options.weather,
                 "day|dusk|night[,fog=METRES][,rain=MM_PER_H] instead of the scenario's");
  app.add_option("--columns", options.columns)->check(CLI::Range(1, 8));
  app.add_option("--output", options.output);
  CLI11_PARSE(app, argc, argv);
  try {
    eod::Run(options);
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
  return 0;
}
