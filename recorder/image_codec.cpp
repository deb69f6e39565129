#include "recorder/image_codec.h"

#include <memory>
#include <stdexcept>
#include <string>

#include <png.h>
#include <turbojpeg.h>

namespace eod::recorder {

std::optional<Picture> DecodeJpeg(std::span<const uint8_t> jpeg) {
  const std::unique_ptr<void, int (*)(tjhandle)> decoder(tjInitDecompress(), tjDestroy);
  if (!decoder || jpeg.empty()) return std::nullopt;
  Picture picture;
  int subsampling = 0;
  int colour_space = 0;
  if (tjDecompressHeader3(decoder.get(), jpeg.data(), jpeg.size(), &picture.width, &picture.height,
                          &subsampling, &colour_space) != 0) {
    return std::nullopt;
  }
  picture.rgb.resize(static_cast<size_t>(picture.width) * picture.height * 3);
  if (tjDecompress2(decoder.get(), jpeg.data(), jpeg.size(), picture.rgb.data(), picture.width, 0,
                    picture.height, TJPF_RGB, 0) != 0) {
    return std::nullopt;
  }
  return picture;
}

std::vector<uint8_t> EncodePng(const Picture& picture) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(picture.width);
  image.height = static_cast<png_uint_32>(picture.height);
  image.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::vector<uint8_t> bytes(size);
  if (png_image_write_to_memory(&image, bytes.data(), &size, 0, picture.rgb.data(), 0, nullptr) ==
      0) {
    throw std::runtime_error(std::string("PNG: ") + image.message);
  }
  bytes.resize(size);
  return bytes;
}

}  // namespace eod::recorder
