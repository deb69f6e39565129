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
#include <sdf/parser.hh>

#include "sim/sdf/sdf_parts.h"
#include "sim/sdf/sdf_schema.h"
#include "sim/sdf/sdf_text.h"
#include "sim/sdf/world_pieces.h"

namespace eod::sim {

namespace {

/// Of models read at a time: some eighty visuals, for which libsdformat takes some 8 MB.
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

/// Reads texts of one file. What libsdformat knows of the format is read once for all of them.
class SdfReader {
 public:
  /// `file` must outlive it; the texts are pieces of `text`.
  SdfReader(const std::filesystem::path& file, const std::string& text) : file_(file) {
    // Errors come back as values. What libsdformat cannot read, it tries as URDF, which talks
    // elsewhere.
    sdf::Console::Instance()->SetQuiet(true);
    console_bridge::noOutputHandler();
    config_.SetWarningsPolicy(sdf::EnforcementPolicy::ERR);
    config_.SetUnrecognizedElementsPolicy(sdf::EnforcementPolicy::ERR);
    sdf_->Root(SchemaFor(text));
  }

  /// Good until the next one.
  const sdf::Root& Read(const std::string& text) {
    root_ = sdf::Root();
    Forget();
    sdf::Errors errors;
    if (sdf::readString(text, config_, sdf_, errors)) {
      const sdf::Errors more = root_.Load(sdf_, config_);
      errors.insert(errors.end(), more.begin(), more.end());
    }
    if (!errors.empty()) Fail(errors.front(), text);
    return root_;
  }

 private:
  /// The last text's elements, and the attributes of its root that are not of the format.
  void Forget() {
    const sdf::ElementPtr root = sdf_->Root();
    root->ClearElements();
    const sdf::Param_V attributes = root->GetAttributes();
    for (const sdf::ParamPtr& attribute : attributes) {
      if (attribute->GetKey() != "version") root->RemoveAttribute(attribute->GetKey());
    }
  }

  [[noreturn]] void Fail(const sdf::Error& error, const std::string& text) const {
    const int line = LineOfError(error, text);
    std::string message = OneLine(error.Message());
    if (message.starts_with("Error reading")) message += ": " + LineOfText(text, line);
    FailAt(file_, line, message);
  }

  const std::filesystem::path& file_;
  sdf::ParserConfig config_;
  sdf::SDFPtr sdf_ = std::make_shared<sdf::SDF>();
  sdf::Root root_;
};

const sdf::World& OnlyWorld(const std::filesystem::path& file, const sdf::Root& root) {
  if (root.WorldCount() == 1) return *root.WorldByIndex(0);
  FailAt(file, 1, fmt::format("holds {} <world>, needs one", root.WorldCount()));
}

void ReadAir(const sdf::World& world, const std::filesystem::path& file, SdfWorld& result) {
  for (uint64_t i = 0; i < world.LightCount(); ++i) {
    const sdf::Light& light = *world.LightByIndex(i);
    if (light.Type() != sdf::LightType::DIRECTIONAL) {
      result.lights.push_back(ToLight(light, true, file));
      continue;
    }
    if (result.sun) continue;
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
                  .lights = {},
                  .background = {},
                  .fog = {},
                  .customs = CustomsOf(world.Element(), file)};
  for (uint64_t i = 0; i < world.FrameCount(); ++i) {
    const sdf::Frame& frame = *world.FrameByIndex(i);
    result.frames.push_back(
        {frame.Name(), Resolve(frame.SemanticPose(), "world", frame.Element(), file)});
  }
  ReadAir(world, file, result);
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
  const std::string text = ReadNumberedSdf(file);
  SdfReader reader(file, text);
  const sdf::Root& root = reader.Read(text);
  if (root.Model() == nullptr) FailAt(file, 1, "holds no <model>");
  return ToModel(*root.Model(), file);
}

SdfWorld ReadSdfWorld(const std::filesystem::path& file) {
  const std::string text = ReadNumberedSdf(file);
  SdfReader reader(file, text);
  std::optional<SdfWorld> result;
  for (const std::string& piece : WorldPieces(text, kPieceBytes)) {
    const sdf::Root& root = reader.Read(piece);
    const sdf::World& world = OnlyWorld(file, root);
    if (!result) result = ReadSurroundings(world, file);
    ReadModels(world, file, result->models);
  }
  return *std::move(result);
}

}  // namespace eod::sim
