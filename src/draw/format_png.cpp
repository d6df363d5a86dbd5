#include <cassert>
#include <cstddef>
#include <new>

#include <png.h>

#include "draw/image.h"

namespace planish {

namespace {

std::string samples_of(const Image& image) {
  std::string samples;
  samples.reserve(image.pixels.size() * 4);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const Color color = image.pixels[i];
    samples += static_cast<char>(color.r);
    samples += static_cast<char>(color.g);
    samples += static_cast<char>(color.b);
    if (!image.alpha.empty()) samples += static_cast<char>(image.alpha[i]);
  }
  return samples;
}

}  // namespace

std::string format_png(const Image& image) {
  assert(image.width > 0 && image.height > 0);
  assert(image.pixels.size() == static_cast<std::size_t>(image.width) * image.height);
  assert(image.alpha.empty() || image.alpha.size() == image.pixels.size());
  png_image header = {};
  header.version = PNG_IMAGE_VERSION;
  header.width = static_cast<png_uint_32>(image.width);
  header.height = static_cast<png_uint_32>(image.height);
  // Twice as large, but somebody waits for the page that pictures are for:
  // docs/notebook/design_decisions.md.
  header.flags = PNG_IMAGE_FLAG_FAST;
  header.format = image.alpha.empty() ? PNG_FORMAT_RGB : PNG_FORMAT_RGBA;
  const std::string samples = samples_of(image);
  std::string png(PNG_IMAGE_PNG_SIZE_MAX(header), '\0');
  png_alloc_size_t size = png.size();
  if (!png_image_write_to_memory(&header, png.data(), &size, 0, samples.data(), 0, nullptr)) {
    // With sound input and a buffer of the largest size, memory is all that can run out.
    throw std::bad_alloc();
  }
  png.resize(size);
  return png;
}

}  // namespace planish
