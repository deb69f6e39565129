#include "recorder/contact_sheet.h"

#include <algorithm>
#include <memory>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <png.h>
#include <turbojpeg.h>

#include "recorder/image_codec.h"

namespace eod::recorder {
namespace {

constexpr Colour kWhite{255, 255, 255};
constexpr Colour kBlack{0, 0, 0};

Jpeg OneColourJpeg(Colour colour) {
  const Canvas canvas(64, 48, colour);
  const std::unique_ptr<void, int (*)(tjhandle)> encoder(tjInitCompress(), tjDestroy);
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  EXPECT_EQ(tjCompress2(encoder.get(), canvas.picture().rgb.data(), 64, 0, 48, TJPF_RGB, &bytes,
                        &size, TJSAMP_444, 100, 0),
            0);
  Jpeg jpeg(bytes, bytes + size);
  tjFree(bytes);
  return jpeg;
}

Colour PixelAt(const Picture& picture, int x, int y) {
  const uint8_t* pixel = &picture.rgb[(static_cast<size_t>(y) * picture.width + x) * 3];
  return {pixel[0], pixel[1], pixel[2]};
}

bool IsNear(Colour a, Colour b) {
  return std::abs(a.red - b.red) < 6 && std::abs(a.green - b.green) < 6 &&
         std::abs(a.blue - b.blue) < 6;
}

bool Overlap(const Rectangle& a, const Rectangle& b) {
  return a.x < b.right() && b.x < a.right() && a.y < b.bottom() && b.y < a.bottom();
}

bool IsInside(const Rectangle& inner, const Rectangle& outer) {
  return inner.x >= outer.x && inner.y >= outer.y && inner.right() <= outer.right() &&
         inner.bottom() <= outer.bottom();
}

TEST(SheetLayout, KeepsEverythingOnTheSheetAndApart) {
  for (size_t count = 0; count <= kSheetMoments; ++count) {
    const SheetLayout dut = LayOutSheet(count);
    const Rectangle sheet{0, 0, dut.width, dut.height};
    std::vector<Rectangle> areas{dut.header, dut.footer};
    ASSERT_EQ(dut.tiles.size(), count);
    for (const SheetLayout::Tile& tile : dut.tiles) {
      areas.push_back(tile.picture);
      areas.push_back(tile.caption);
      EXPECT_TRUE(IsInside(tile.inset, tile.picture));
      // Cameras are 4:3; nothing is stretched.
      EXPECT_EQ(tile.picture.width * 3, tile.picture.height * 4);
    }
    for (size_t i = 0; i < areas.size(); ++i) {
      EXPECT_TRUE(IsInside(areas[i], sheet)) << count << " tiles, area " << i;
      for (size_t j = 0; j < i; ++j) EXPECT_FALSE(Overlap(areas[i], areas[j])) << i << ' ' << j;
    }
  }
}

TEST(SheetLayout, HasRowsOfThree) {
  const SheetLayout dut = LayOutSheet(4);
  EXPECT_EQ(dut.tiles[0].picture.y, dut.tiles[2].picture.y);
  EXPECT_EQ(dut.tiles[0].picture.x, dut.tiles[3].picture.x);
  EXPECT_GT(dut.tiles[3].picture.y, dut.tiles[0].caption.bottom());
}

TEST(ContactSheet, ShowsTheDriveCameraWithTheMastInset) {
  const Colour drive{200, 40, 40};
  const Colour mast{40, 40, 200};
  Moment moment;
  moment.label = "Contact";
  moment.pictures = {{Camera::kDrive, OneColourJpeg(drive)}, {Camera::kMast, OneColourJpeg(mast)}};
  const std::vector<Moment> moments{moment};
  const Picture dut = DrawContactSheet({}, moments, LoadTypefaces());
  const SheetLayout::Tile tile = LayOutSheet(1).tiles[0];
  EXPECT_TRUE(IsNear(PixelAt(dut, tile.picture.x + 5, tile.picture.bottom() - 5), drive));
  EXPECT_TRUE(IsNear(
      PixelAt(dut, tile.inset.x + tile.inset.width / 2, tile.inset.y + tile.inset.height / 2),
      mast));
}

TEST(ContactSheet, DrawsCaptionsAndTitle) {
  Moment moment;
  moment.label = "Contact";
  const std::vector<Moment> moments{moment};
  const Picture dut = DrawContactSheet({}, moments, LoadTypefaces());
  const SheetLayout layout = LayOutSheet(1);
  const auto is_drawn_on = [&](const Rectangle& area) {
    const Colour paper = PixelAt(dut, 0, 0);
    for (int y = area.y; y < area.bottom(); ++y) {
      for (int x = area.x; x < area.right(); ++x) {
        if (!(PixelAt(dut, x, y) == paper)) return true;
      }
    }
    return false;
  };
  EXPECT_TRUE(is_drawn_on(layout.tiles[0].caption));
  EXPECT_TRUE(is_drawn_on({layout.header.x, layout.header.y, 200, 60}));
}

TEST(ContactSheet, SurvivesABrokenPicture) {
  Moment moment;
  moment.pictures[Camera::kDrive] = {0xFF, 0xD8, 0x00};
  const std::vector<Moment> moments{moment};
  EXPECT_NO_THROW(DrawContactSheet({}, moments, LoadTypefaces()));
}

TEST(Png, HoldsThePictureItWasGiven) {
  Canvas canvas(3, 2, kWhite);
  canvas.Blend(2, 1, {10, 20, 30}, 255);
  const std::vector<uint8_t> bytes = EncodePng(canvas.picture());
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  ASSERT_NE(png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()), 0);
  image.format = PNG_FORMAT_RGB;
  std::vector<uint8_t> rgb(PNG_IMAGE_SIZE(image));
  ASSERT_NE(png_image_finish_read(&image, nullptr, rgb.data(), 0, nullptr), 0);
  EXPECT_EQ(rgb, canvas.picture().rgb);
}

TEST(Canvas, ScalesByTheMeanOfWhatAPixelCovers) {
  // 4x2 black and white columns to 2x1: each pixel covers one black and one white column.
  Picture stripes{4, 2, {}};
  for (int i = 0; i < 8; ++i) stripes.rgb.insert(stripes.rgb.end(), 3, i % 2 == 0 ? 0 : 255);
  Canvas dut(2, 1, kBlack);
  dut.Place(stripes, {0, 0, 2, 1});
  EXPECT_EQ(dut.At(0, 0), (Colour{128, 128, 128}));
  EXPECT_EQ(dut.At(1, 0), (Colour{128, 128, 128}));
}

TEST(Canvas, ClipsWhatLiesOutside) {
  Canvas dut(4, 4, kBlack);
  dut.FillRounded({-10, -10, 12, 12}, 3, kWhite);
  dut.Fill({3, 3, 100, 100}, kWhite);
  EXPECT_EQ(dut.At(0, 0), kWhite);
  EXPECT_EQ(dut.At(3, 3), kWhite);
  EXPECT_EQ(dut.At(3, 0), kBlack);
}

TEST(Canvas, RoundsCorners) {
  Canvas dut(20, 20, kBlack);
  dut.FillRounded({0, 0, 20, 20}, 8, kWhite);
  EXPECT_EQ(dut.At(0, 0), kBlack);
  EXPECT_EQ(dut.At(19, 19), kBlack);
  EXPECT_EQ(dut.At(10, 0), kWhite);
  EXPECT_EQ(dut.At(10, 10), kWhite);
}

TEST(Typeface, ShortensWhatDoesNotFit) {
  const Typefaces dut = LoadTypefaces();
  const std::string text = "Drive forward until the wall stops you";
  EXPECT_EQ(dut.regular.Fitted(text, 20, 10'000), text);
  const std::string fitted = dut.regular.Fitted(text, 20, 150);
  EXPECT_TRUE(fitted.ends_with("…"));
  EXPECT_LE(dut.regular.Measure(fitted, 20), 150);
  EXPECT_EQ(dut.regular.Fitted(text, 20, 1), "");
}

TEST(Typeface, SurvivesTextThatIsNotUtf8) {
  Canvas canvas(100, 30, kBlack);
  const Typefaces dut = LoadTypefaces();
  EXPECT_GT(dut.bold.Draw(canvas, 0, 20, "\xC3\x28\xFF\xE2\x82", 16, kWhite), 0);
}

TEST(Typeface, NamesThePackageOfAMissingFont) {
  try {
    const Typeface dut("/nowhere/at.ttf");
    FAIL() << "accepted";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("/nowhere/at.ttf"));
    EXPECT_THAT(error.what(), testing::HasSubstr("fonts-dejavu-core"));
  }
}

}  // namespace
}  // namespace eod::recorder
