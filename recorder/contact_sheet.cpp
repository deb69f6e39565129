#include "recorder/contact_sheet.h"

#include <array>
#include <string>

#include <fmt/format.h>

#include "recorder/image_codec.h"
#include "recorder/status_line.h"

namespace eod::recorder {
namespace {

constexpr int kColumns = 3;
constexpr int kMargin = 40;
constexpr int kGap = 24;
constexpr int kTileWidth = 512;
constexpr int kTileHeight = 384;
constexpr int kCaptionHeight = 74;
constexpr int kHeaderHeight = 104;
constexpr int kFooterHeight = 84;

constexpr Colour kPaper{247, 247, 244};
constexpr Colour kInk{28, 32, 36};
constexpr Colour kFaint{112, 118, 124};
constexpr Colour kLine{214, 216, 212};
constexpr Colour kWhite{255, 255, 255};
constexpr Colour kGreen{46, 125, 80};
constexpr Colour kRed{190, 52, 44};
constexpr Colour kAmber{196, 130, 20};
constexpr Colour kBlue{52, 98, 160};
constexpr Colour kGrey{110, 116, 122};

Colour ColourOf(dbc::Lamp lamp) {
  switch (lamp) {
    case dbc::Lamp::kEstop:
    case dbc::Lamp::kCollision:
    case dbc::Lamp::kArmed:
    case dbc::Lamp::kFired:
    case dbc::Lamp::kFault:
      return kRed;
    case dbc::Lamp::kLimit:
    case dbc::Lamp::kTilt:
    case dbc::Lamp::kBattery:
      return kAmber;
    case dbc::Lamp::kMission:
    case dbc::Lamp::kCamera:
      return kBlue;
    case dbc::Lamp::kPower:
    case dbc::Lamp::kLink:
    case dbc::Lamp::kDeadman:
    case dbc::Lamp::kGrasp:
      return kGreen;
  }
  return kGrey;
}

Colour ColourOf(const std::string& result) {
  return result == "success" ? kGreen : result == "fail" ? kRed : kGrey;
}

// A word in a filled shape, its left edge at `x`; returns the right edge.
int DrawChip(Canvas& canvas, const Typeface& typeface, int x, int y, std::string_view word,
             int size, Colour colour) {
  const int padding = size / 2;
  const int height = size * 3 / 2;
  const int width = typeface.Measure(word, size) + 2 * padding;
  canvas.FillRounded({x, y, width, height}, size / 4, colour);
  typeface.Draw(canvas, x + padding, y + size + size / 8, word, size, kWhite);
  return x + width;
}

class SheetPainter {
 public:
  SheetPainter(const SheetLayout& layout, const Typefaces& typefaces)
      : layout_(layout), fonts_(typefaces), canvas_(layout.width, layout.height, kPaper) {}

  void DrawHeader(const Summary& summary) {
    const Rectangle& area = layout_.header;
    const std::string title = fmt::format("EOD training run, module {}", summary.module);
    const int after = fonts_.bold.Draw(canvas_, area.x, area.y + 50, title, 40, kInk);
    DrawChip(canvas_, fonts_.bold, after + 22, area.y + 20, summary.result, 22,
             ColourOf(summary.result));
    const std::string line =
        fmt::format("{:.1f} s simulated  ·  {}  ·  {} {}", summary.sim_seconds, summary.bus,
                    summary.alarms.size(), summary.alarms.size() == 1 ? "alarm" : "alarms");
    fonts_.regular.Draw(canvas_, area.right() - fonts_.regular.Measure(line, 20), area.y + 48, line,
                        20, kFaint);
    canvas_.Fill({area.x, area.y + 76, area.width, 2}, kLine);
  }

  void DrawTile(const SheetLayout::Tile& tile, const Moment& moment) {
    canvas_.Fill(tile.picture, kLine);
    // The map's order is that of worth.
    auto picture = moment.pictures.begin();
    if (picture != moment.pictures.end()) Show((picture++)->second, tile.picture);
    if (picture != moment.pictures.end()) {
      const Rectangle& inset = tile.inset;
      canvas_.Fill({inset.x - 2, inset.y - 2, inset.width + 4, inset.height + 4}, kPaper);
      Show(picture->second, inset);
    }
    DrawDisplay(tile.picture, moment);
    DrawCaption(tile.caption, moment);
  }

  void DrawFooter(const Summary& summary) {
    const Rectangle& area = layout_.footer;
    canvas_.Fill({area.x, area.y, area.width, 2}, kLine);
    const std::array<std::pair<std::string, std::string>, 4> numbers{{
        {"button to pose, p99", Milliseconds(summary.latency_ms.button_to_pose)},
        {"contact to lamp frame, p99", Milliseconds(summary.latency_ms.contact_to_lamp_frame)},
        {"camera", fmt::format("{:.1f} fps, {}x{}", summary.camera.fps, summary.camera.width,
                               summary.camera.height)},
        {"CAN",
         fmt::format("{:.1f} % load, {} lost", summary.can.bus_load_percent, summary.can.lost)},
    }};
    int x = area.x;
    for (const auto& [name, value] : numbers) {
      fonts_.regular.Draw(canvas_, x, area.y + 34, name, 18, kFaint);
      fonts_.bold.Draw(canvas_, x, area.y + 62, value, 22, kInk);
      x += area.width / static_cast<int>(numbers.size());
    }
  }

  const Picture& picture() const { return canvas_.picture(); }

 private:
  void Show(const Jpeg& jpeg, const Rectangle& area) {
    if (const auto picture = DecodeJpeg(jpeg)) canvas_.Place(*picture, area);
  }

  // Time and speed in a corner of the picture, as a camera would show them.
  void DrawDisplay(const Rectangle& picture, const Moment& moment) {
    const std::string text = fmt::format("{:.1f} s   {:+.2f} m/s", moment.t, moment.speed_mps);
    DrawChip(canvas_, fonts_.regular, picture.x + 10, picture.bottom() - 36, text, 17, kInk);
  }

  void DrawCaption(const Rectangle& area, const Moment& moment) {
    fonts_.bold.Draw(canvas_, area.x, area.y + 30, fonts_.bold.Fitted(moment.label, 20, area.width),
                     20, kInk);
    int chip = area.x;
    for (size_t i = 0; i < moment.lamps.size(); ++i) {
      if (moment.lamps[i] == dbc::LampPattern::kOff) continue;
      const auto lamp = static_cast<dbc::Lamp>(i);
      const std::string_view name = LampName(lamp);
      if (chip + fonts_.regular.Measure(name, 15) + 15 > area.right()) break;
      chip = DrawChip(canvas_, fonts_.regular, chip, area.y + 44, name, 15, ColourOf(lamp)) + 6;
    }
  }

  static std::string Milliseconds(const Percentiles& percentiles) {
    return percentiles.p99 ? fmt::format("{:.2f} ms", *percentiles.p99) : "no sample";
  }

  const SheetLayout& layout_;
  const Typefaces& fonts_;
  Canvas canvas_;
};

}  // namespace

SheetLayout LayOutSheet(size_t tiles) {
  const int count = static_cast<int>(tiles);
  const int rows = (count + kColumns - 1) / kColumns;
  const int inner = kColumns * kTileWidth + (kColumns - 1) * kGap;
  SheetLayout layout;
  layout.width = inner + 2 * kMargin;
  layout.header = {kMargin, kMargin / 2, inner, kHeaderHeight - kMargin / 2};
  for (int i = 0; i < count; ++i) {
    const int x = kMargin + i % kColumns * (kTileWidth + kGap);
    const int y =
        kHeaderHeight + kMargin / 2 + i / kColumns * (kTileHeight + kCaptionHeight + kGap);
    SheetLayout::Tile tile;
    tile.picture = {x, y, kTileWidth, kTileHeight};
    tile.inset = {x + kTileWidth * 2 / 3 - 10, y + 10, kTileWidth / 3, kTileHeight / 3};
    tile.caption = {x, y + kTileHeight, kTileWidth, kCaptionHeight};
    layout.tiles.push_back(tile);
  }
  const int below = kHeaderHeight + kMargin / 2 + rows * (kTileHeight + kCaptionHeight + kGap);
  layout.footer = {kMargin, below, inner, kFooterHeight};
  layout.height = layout.footer.bottom() + kMargin / 2;
  return layout;
}

Picture DrawContactSheet(const Summary& summary, std::span<const Moment> moments,
                         const Typefaces& typefaces) {
  const SheetLayout layout = LayOutSheet(moments.size());
  SheetPainter painter(layout, typefaces);
  painter.DrawHeader(summary);
  for (size_t i = 0; i < moments.size(); ++i) painter.DrawTile(layout.tiles[i], moments[i]);
  painter.DrawFooter(summary);
  return painter.picture();
}

}  // namespace eod::recorder
