#include <cstddef>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <png.h>

#include "draw/image.h"

namespace planish {
namespace {

Image some_image(int width, int height, bool with_alpha) {
  Image image{width, height, {}};
  for (int i = 0; i < width * height; ++i) {
    image.pixels.push_back({static_cast<std::uint8_t>(7 * i), static_cast<std::uint8_t>(i / 3),
                            static_cast<std::uint8_t>(255 - i)});
    if (with_alpha) image.alpha.push_back(static_cast<std::uint8_t>(11 * i));
  }
  return image;
}

// The samples of a PNG file, `channels` bytes a pixel.
std::vector<std::uint8_t> decode(const std::string& png, int width, int height, bool with_alpha) {
  png_image header = {};
  header.version = PNG_IMAGE_VERSION;
  EXPECT_TRUE(png_image_begin_read_from_memory(&header, png.data(), png.size()));
  EXPECT_EQ(static_cast<int>(header.width), width);
  EXPECT_EQ(static_cast<int>(header.height), height);
  EXPECT_EQ(header.format, with_alpha ? PNG_FORMAT_RGBA : PNG_FORMAT_RGB);
  std::vector<std::uint8_t> samples(PNG_IMAGE_SIZE(header));
  EXPECT_TRUE(png_image_finish_read(&header, nullptr, samples.data(), 0, nullptr));
  return samples;
}

TEST(WritePng, DecodesToTheSamePixels) {
  for (const auto& [width, height] : {std::pair{1, 1}, std::pair{37, 21}, std::pair{3, 200}}) {
    for (const bool with_alpha : {false, true}) {
      const Image image = some_image(width, height, with_alpha);
      const auto samples = decode(format_png(image), width, height, with_alpha);
      const std::size_t channels = with_alpha ? 4 : 3;
      ASSERT_EQ(samples.size(), channels * image.pixels.size());
      for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const std::uint8_t* sample = samples.data() + channels * i;
        ASSERT_EQ((Color{sample[0], sample[1], sample[2]}), image.pixels[i]) << i;
        ASSERT_EQ(with_alpha ? sample[3] : 0, with_alpha ? image.alpha[i] : 0) << i;
      }
    }
  }
}

TEST(WritePng, GivesTheSameBytesForTheSameImage) {
  EXPECT_EQ(format_png(some_image(16, 9, true)), format_png(some_image(16, 9, true)));
}

}  // namespace
}  // namespace planish
