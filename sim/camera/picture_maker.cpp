#include "sim/camera/picture_maker.h"

#include <algorithm>
#include <array>

#include "sim/camera/camera_choice.h"

namespace eod::sim {
namespace {

constexpr std::array<const char*, 4> kQuarters{"drive", "gripper", "mast", "rear"};
constexpr std::array<uint8_t, 3> kBlack{0, 0, 0};
constexpr std::array<uint8_t, 3> kSeparator{16, 18, 20};
constexpr int kLostShade = 120;  // of 255 over the last picture of a link that is gone

uint32_t SeedOf(const CameraSpec& camera, const SceneSnapshot& snapshot) {
  uint32_t seed = Hash(static_cast<uint32_t>(ToUtime(snapshot.time)), snapshot.seed);
  for (const char letter : camera.name) seed = Hash(seed, static_cast<unsigned char>(letter));
  return seed;
}

}  // namespace

std::vector<PictureView> ViewsOf(const RobotModel& robot, std::string_view picture, int width,
                                 int height) {
  if (picture != kQuadPicture) {
    return {{&FindCamera(robot, std::string(picture)), {0, 0, width, height}}};
  }
  std::vector<PictureView> views;
  for (size_t i = 0; i < kQuarters.size(); ++i) {
    const int right = static_cast<int>(i % 2), below = static_cast<int>(i / 2);
    const PixelArea area{right * (width / 2), (1 - below) * (height / 2), width / 2, height / 2};
    views.push_back({&FindCamera(robot, kQuarters[i]), area});
  }
  return views;
}

PictureMaker::PictureMaker(const GlFunctions& gl, const RobotModel& robot, const WorldModel& world,
                           int width, int height, bool draw_data)
    : robot_(robot),
      renderer_(gl, robot, world),
      target_(gl, width, height),
      whole_{Sensor(width, height), {}},
      quarter_{Sensor(width / 2, height / 2), {}} {
  if (!draw_data) return;
  whole_.data.emplace(height);
  quarter_.data.emplace(height / 2);
}

void PictureMaker::Show(const SceneSnapshot& snapshot) {
  snapshot_ = snapshot;
  prepared_.reset();
  KeepFrozen();
}

/// A frozen camera shows the moment in which its fault began; in another module it starts anew.
void PictureMaker::KeepFrozen() {
  std::erase_if(frozen_, [&](const auto& entry) {
    return entry.second.module != snapshot_.module ||
           !FaultsOf(FindCamera(robot_, entry.first)).is_frozen;
  });
  for (const CameraSpec& camera : robot_.cameras) {
    if (FaultsOf(camera).is_frozen) frozen_.try_emplace(camera.name, snapshot_);
  }
}

PictureMaker::Faults PictureMaker::FaultsOf(const CameraSpec& camera) const {
  Faults faults;
  for (const CameraFault& fault : snapshot_.faults) {
    if (fault.camera != camera.name) continue;
    if (fault.kind == CameraFault::Kind::kDead) faults.is_dead = true;
    if (fault.kind == CameraFault::Kind::kFrozen) faults.is_frozen = true;
    if (fault.kind == CameraFault::Kind::kNoisy) faults.exposure.is_noisy = true;
    if (fault.kind == CameraFault::Kind::kWrongLight) faults.exposure.stops = fault.stops;
  }
  return faults;
}

const SceneSnapshot& PictureMaker::SnapshotOf(const CameraSpec& camera) const {
  const auto frozen = frozen_.find(camera.name);
  return frozen == frozen_.end() ? snapshot_ : frozen->second;
}

void PictureMaker::Render(const std::vector<PictureView>& views) {
  DrawCounters shadow;
  counters_ = {};
  for (const PictureView& view : views) {
    if (FaultsOf(*view.camera).is_dead) continue;
    // All cameras of one moment share its shadow; a frozen one has a moment of its own.
    const std::string moment = frozen_.contains(view.camera->name) ? view.camera->name : "";
    if (prepared_ != moment) renderer_.Prepare(SnapshotOf(*view.camera));
    prepared_ = moment;
    const DrawCounters drawn = renderer_.Draw(*view.camera, target_, view.area);
    shadow = renderer_.shadow_counters();
    counters_.triangles += drawn.triangles - shadow.triangles;
    counters_.draw_calls += drawn.draw_calls - shadow.draw_calls;
  }
  counters_.triangles += shadow.triangles;
  counters_.draw_calls += shadow.draw_calls;
}

const std::vector<uint8_t>& PictureMaker::Make(const std::string& picture) {
  const std::vector<PictureView> views =
      ViewsOf(robot_, picture, target_.width(), target_.height());
  Render(views);
  target_.Read(pixels_);
  const PixelView all = PixelView::Of(pixels_, target_.width(), target_.height());
  for (const PictureView& view : views) Finish(view, all.Part(view.area));
  if (views.size() > 1) Separate(all);
  links_[picture].Carry(snapshot_.link_quality, snapshot_.time, snapshot_.seed, all);
  if (PictureLink::IsLost(snapshot_.link_quality)) {
    FillRectangle(all, 0, 0, all.width, all.height, kBlack, kLostShade);
    if (whole_.data) whole_.data->DrawNoSignal(all);
  }
  return pixels_;
}

PictureMaker::Brush& PictureMaker::BrushFor(const PixelArea& area) {
  return area == target_.whole() ? whole_ : quarter_;
}

/// All that happens to a picture after the lens.
void PictureMaker::Finish(const PictureView& view, const PixelView& pixels) {
  Brush& brush = BrushFor(view.area);
  const SceneSnapshot& snapshot = SnapshotOf(*view.camera);
  Faults faults = FaultsOf(*view.camera);
  if (faults.is_dead) {
    FillRectangle(pixels, 0, 0, pixels.width, pixels.height, kBlack);
    if (!brush.data) return;
    OnScreenText name;
    name.name = TextOf(robot_, *view.camera, snapshot, pixels.width).name;
    brush.data->Draw(name, pixels);
    brush.data->DrawNoSignal(pixels);
    return;
  }
  faults.exposure.seed = SeedOf(*view.camera, snapshot);
  brush.sensor.Expose(faults.exposure, pixels);
  if (brush.data) {
    brush.data->Draw(TextOf(robot_, *view.camera, snapshot, pixels.width), pixels);
  }
}

void PictureMaker::Separate(const PixelView& picture) const {
  FillRectangle(picture, picture.width / 2 - 1, 0, 2, picture.height, kSeparator);
  FillRectangle(picture, 0, picture.height / 2 - 1, picture.width, 2, kSeparator);
}

}  // namespace eod::sim
