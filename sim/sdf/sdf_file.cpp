#include "sim/sdf/sdf_file.h"

#include <algorithm>

#include <console_bridge/console.h>
#include <fmt/format.h>
#include <sdf/Console.hh>
#include <sdf/Frame.hh>
#include <sdf/Light.hh>
#include <sdf/Root.hh>
#include <sdf/Scene.hh>
#include <sdf/World.hh>

#include "sim/sdf/sdf_parts.h"
#include "sim/sdf/sdf_text.h"
#include "sim/sdf/world_pieces.h"

namespace eod::sim {

namespace {

/// Of models read at a time: some eighty visuals, for which libsdformat takes some 60 MB.
constexpr size_t kPieceBytes = 32'000;

/// One line of text, without the line breaks that some messages of libsdformat end with.
std::string OneLine(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  text.erase(text.find_last_not_of(' ') + 1);
  return text;
}

/// Line of an error: as libsdformat says, or where the first [name] of its message stands.
int LineOfError(const sdf::Error& error, const std::string& text) {
  if (error.LineNumber()) return *error.LineNumber();
  const std::string message = error.Message();
  const size_t begin = message.find('[');
  const size_t end = message.find(']', begin);
  if (begin == std::string::npos || end == std::string::npos) return 0;
  return LineOfWord(text, message.substr(begin + 1, end - begin - 1));
}

sdf::Root Load(const std::filesystem::path& file, const std::string& text) {
  // Errors come back as values. What libsdformat cannot read, it tries as URDF, which talks
  // elsewhere.
  sdf::Console::Instance()->SetQuiet(true);
  console_bridge::noOutputHandler();
  sdf::ParserConfig config;
  config.SetWarningsPolicy(sdf::EnforcementPolicy::ERR);
  config.SetUnrecognizedElementsPolicy(sdf::EnforcementPolicy::ERR);
  sdf::Root root;
  const sdf::Errors errors = root.LoadSdfString(text, config);
  if (errors.empty()) return root;
  const int line = LineOfError(errors.front(), text);
  std::string message = OneLine(errors.front().Message());
  if (message.starts_with("Error reading")) message += ": " + LineOfText(text, line);
  FailAt(file, line, message);
}

const sdf::World& OnlyWorld(const std::filesystem::path& file, const sdf::Root& root) {
  if (root.WorldCount() == 1) return *root.WorldByIndex(0);
  FailAt(file, 1, fmt::format("holds {} <world>, needs one", root.WorldCount()));
}

void ReadAir(const sdf::World& world, SdfWorld& result) {
  for (uint64_t i = 0; i < world.LightCount() && !result.sun; ++i) {
    const sdf::Light& light = *world.LightByIndex(i);
    if (light.Type() != sdf::LightType::DIRECTIONAL) continue;
    const auto direction = light.Direction().Normalized();
    result.sun = SdfSun{
        .direction = Eigen::Vector3d(direction.X(), direction.Y(), direction.Z()).cast<float>(),
        .colour = ToColour(light.Diffuse())};
  }
  const sdf::Scene* scene = world.Scene();
  if (scene == nullptr || !scene->Element()) return;
  result.background = ToColour(scene->Background());
  if (!scene->Element()->HasElement("fog")) return;
  const sdf::ElementPtr fog = scene->Element()->GetElement("fog");
  result.fog = SdfFog{.colour = ToColour(fog->Get<ignition::math::Color>("color")),
                      .density = static_cast<float>(fog->Get<double>("density"))};
}

/// All but the models.
SdfWorld ReadSurroundings(const sdf::World& world, const std::filesystem::path& file) {
  SdfWorld result{.name = world.Name(),
                  .line = LineOf(world.Element()),
                  .frames = {},
                  .models = {},
                  .sun = {},
                  .background = {},
                  .fog = {},
                  .customs = CustomsOf(world.Element(), file)};
  for (uint64_t i = 0; i < world.FrameCount(); ++i) {
    const sdf::Frame& frame = *world.FrameByIndex(i);
    result.frames.push_back(
        {frame.Name(), Resolve(frame.SemanticPose(), "world", frame.Element(), file)});
  }
  ReadAir(world, result);
  return result;
}

void ReadModels(const sdf::World& world, const std::filesystem::path& file,
                std::vector<SdfModel>& models) {
  for (uint64_t i = 0; i < world.ModelCount(); ++i) {
    SdfModel model = ToModel(*world.ModelByIndex(i), file);
    // libsdformat sees only the names of one piece.
    const auto same = std::find_if(models.begin(), models.end(), [&model](const SdfModel& one) {
      return one.name == model.name;
    });
    if (same != models.end()) {
      FailAt(file, model.line,
             fmt::format("second model {}; the first is in line {}", model.name, same->line));
    }
    models.push_back(std::move(model));
  }
}

}  // namespace

SdfModel ReadSdfModel(const std::filesystem::path& file) {
  const sdf::Root root = Load(file, ReadNumberedSdf(file));
  if (root.Model() == nullptr) FailAt(file, 1, "holds no <model>");
  return ToModel(*root.Model(), file);
}

SdfWorld ReadSdfWorld(const std::filesystem::path& file) {
  std::optional<SdfWorld> result;
  for (const std::string& piece : WorldPieces(ReadNumberedSdf(file), kPieceBytes)) {
    const sdf::Root root = Load(file, piece);
    const sdf::World& world = OnlyWorld(file, root);
    if (!result) result = ReadSurroundings(world, file);
    ReadModels(world, file, result->models);
  }
  return *std::move(result);
}

}  // namespace eod::sim
