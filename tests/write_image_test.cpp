// SPDX-License-Identifier: Apache-2.0
// Every writer through our own readers and OpenEXR's library, and what they answer to what they
// cannot write.
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfStringAttribute.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <bit>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>
#include <string>
#include <zraka/image.hpp>
#include <zraka/write_image.hpp>

#include "image/half.hpp"
#include "image/transfer.hpp"

namespace zraka {
namespace {

namespace fs = std::filesystem;

class WriteImage : public testing::Test {
 protected:
  WriteImage() { fs::create_directories(folder_); }
  ~WriteImage() override { fs::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  static std::string bytes_of(const std::string& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  /// The picture as it comes back.
  ReadImage back(const Image& image, const std::string& name, const WriteOptions& options = {},
                 const Layers& layers = {}) const {
    const Result<void> written = write_image(image, layers, path(name), options);
    EXPECT_TRUE(written) << to_string(written.error().front());
    return read_image(path(name)).value();
  }
  std::string error(const std::string& name, const WriteOptions& options = {},
                    const Layers& layers = {}, const Image& image = Image(2, 1)) const {
    const Result<void> written = write_image(image, layers, name, options);
    return written ? "written" : to_string(written.error().front());
  }

  const fs::path folder_ = fs::path(testing::TempDir()) / ("zraka-write-image-" + std::to_string(::getpid()));
};

/// Light from 0 to 1.5, and at some places what is none.
Image light(std::uint32_t width = 37, std::uint32_t height = 21) {
  Image image(width, height);
  std::mt19937 random(5);
  for (float& value : image.pixels) value = static_cast<float>(random() % 3000) / 2000.0f;
  if (image.pixels.size() < 9) return image;
  image.pixels[0] = -1;
  image.pixels[4] = std::nanf("");
  image.pixels[8] = std::numeric_limits<float>::infinity();
  return image;
}

/// All of a channel of an OpenEXR, converted to T by OpenEXR's library.
template <class T>
std::vector<T> exr_channel(const std::string& path, const std::string& name) {
  Imf::InputFile file(path.c_str());
  const auto window = file.header().dataWindow();
  const auto width = static_cast<std::size_t>(window.max.x + 1);
  const auto height = static_cast<std::size_t>(window.max.y + 1);
  std::vector<T> values(width * height);
  Imf::FrameBuffer buffer;
  buffer.insert(name,
                Imf::Slice(std::is_same_v<T, float> ? Imf::FLOAT : Imf::UINT,
                           reinterpret_cast<char*>(values.data()), sizeof(T), sizeof(T) * width));
  file.setFrameBuffer(buffer);
  file.readPixels(window.min.y, window.max.y);
  return values;
}

TEST_F(WriteImage, IntegersComeBackAsQuantized) {
  const Image image = light();
  for (const char* name : {"a.png", "a.ppm", "a.PNG"})
    for (const Transfer transfer : {Transfer::linear, Transfer::srgb})
      for (const int bits : {8, 16}) {
        const ReadImage read = back(image, name, {.bits = bits, .transfer = transfer});
        EXPECT_EQ(read.bits, bits);
        ASSERT_EQ(read.image.width, image.width);
        ASSERT_EQ(read.image.height, image.height);
        const float most = bits == 16 ? 65535 : 255;
        for (std::size_t i = 0; i < image.pixels.size(); ++i)
          ASSERT_EQ(read.image.pixels[i],
                    static_cast<float>(quantize(image.pixels[i], transfer, bits)) / most)
              << name << " " << i;
      }
}

TEST_F(WriteImage, PngIsTheOneOfWritePng) {
  const Image image = light();
  ASSERT_TRUE(write_image(image, {}, path("a.png")));
  EXPECT_EQ(bytes_of(path("a.png")), encode_png(image, {8, Transfer::srgb}).value());
}

TEST_F(WriteImage, PfmComesBackToTheBit) {
  const Image image = light();
  const ReadImage read = back(image, "a.pfm");
  EXPECT_EQ(read.format, "PFM");
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    ASSERT_EQ(std::bit_cast<std::uint32_t>(read.image.pixels[i]),
              std::bit_cast<std::uint32_t>(image.pixels[i]))
        << i;
  // The last row comes first.
  const std::string bytes = bytes_of(path("a.pfm"));
  float first = 0;
  std::memcpy(&first, bytes.data() + std::string("PF\n37 21\n-1.0\n").size(), sizeof(first));
  EXPECT_EQ(first, image.row(20)[0]);
}

TEST_F(WriteImage, HdrComesBackToHalfAStepOfTheBrightest) {
  // Widths on both sides of where runs are possible, and rows that have some.
  for (const std::uint32_t width : {1u, 7u, 8u, 300u}) {
    Image image = light(width, 9);
    for (std::uint32_t x = 0; x < width; ++x)
      for (int c = 0; c < 3; ++c) {
        image.row(7)[3 * x + static_cast<std::size_t>(c)] = 1;  // a run
        image.row(8)[3 * x + static_cast<std::size_t>(c)] =
            std::ldexp(0.9999f, static_cast<int>(x % 200) - 100);
      }
    const ReadImage read = back(image, "a.hdr");
    EXPECT_EQ(read.format, "Radiance HDR");
    for (std::size_t p = 3; p < image.pixels.size() / 3; ++p) {
      const float* want = image.pixels.data() + 3 * p;
      const float* got = read.image.pixels.data() + 3 * p;
      const float most = std::max({want[0], want[1], want[2]});
      for (int c = 0; c < 3; ++c) ASSERT_NEAR(got[c], want[c], most / 255) << width << " " << p;
    }
  }
  EXPECT_EQ(back(light(), "a.hdr").image.pixels[0], 0);  // below 0
}

TEST_F(WriteImage, JpegIsNearAndNearerWithMoreQuality) {
  Image image(64, 48);
  for (std::uint32_t y = 0; y < 48; ++y)
    for (std::uint32_t x = 0; x < 64; ++x)
      for (std::size_t c = 0; c < 3; ++c)
        image.row(y)[3 * x + c] =
            0.5f + 0.4f * std::sin(0.2f * static_cast<float>(x + y) + static_cast<float>(c));
  const auto error = [&](int quality) {
    const ReadImage read =
        back(image, "a.jpg", {.transfer = Transfer::linear, .jpeg_quality = quality});
    EXPECT_EQ(read.format, "JPEG");
    double sum = 0;
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
      sum += std::fabs(static_cast<double>(read.image.pixels[i] - image.pixels[i]));
    return sum / static_cast<double>(image.pixels.size());
  };
  EXPECT_LT(error(100), 0.004);
  EXPECT_LT(error(100), error(40));
  EXPECT_LT(error(40), 0.03);
  // A sample of each channel for each pixel: 1×1 three times in the frame's header.
  const std::string bytes = bytes_of(path("a.jpg"));
  const std::size_t frame = bytes.find("\xFF\xC0");
  ASSERT_NE(frame, std::string::npos);
  for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(bytes[frame + 11 + 3 * c], 0x11);
}

TEST_F(WriteImage, ExrComesBackAsHalvesOrToTheBit) {
  const Image image = light();
  for (const int bits : {16, 32}) {
    const ReadImage read = back(image, "a.exr", {.bits = bits});
    EXPECT_EQ(read.format, "OpenEXR");
    EXPECT_EQ(read.bits, bits);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
      if (std::isnan(image.pixels[i])) {
        ASSERT_TRUE(std::isnan(read.image.pixels[i]));
      } else if (bits == 32 || std::isinf(image.pixels[i])) {
        ASSERT_EQ(read.image.pixels[i], image.pixels[i]) << i;
      } else {
        ASSERT_NEAR(read.image.pixels[i], image.pixels[i],
                    std::fabs(image.pixels[i]) * 0x1p-11f + 0x1p-25f);
      }
    }
  }
}

TEST(Half, IsTheNearest) {
  // Every half and what lies between it and the next: rounded as exact arithmetic rounds.
  const auto value = [](std::uint16_t h) {
    const int exponent = h >> 10 & 0x1F;
    const double fraction = h & 0x3FF;
    return exponent == 0 ? std::ldexp(fraction, -24) : std::ldexp(1024 + fraction, exponent - 25);
  };
  for (std::uint16_t h = 0; h < 0x7BFF; ++h) {
    const double low = value(h), high = value(static_cast<std::uint16_t>(h + 1));
    const auto middle = static_cast<float>((low + high) / 2);
    ASSERT_EQ(half_of(static_cast<float>(low)), h);
    ASSERT_EQ(half_of(-static_cast<float>(low)), h | 0x8000);
    ASSERT_EQ(half_of(middle), h % 2 == 0 ? h : h + 1) << h;
    ASSERT_EQ(half_of(std::nextafter(middle, 0.0f)), h) << h;
    ASSERT_EQ(half_of(std::nextafter(middle, 1e9f)), h + 1) << h;
  }
  EXPECT_EQ(half_of(1e9f), 0x7BFF);
  EXPECT_EQ(half_of(std::numeric_limits<float>::infinity()), 0x7C00);
  EXPECT_EQ(half_of(-std::numeric_limits<float>::infinity()), 0xFC00);
  EXPECT_EQ(half_of(std::nanf("")) & 0x7E00, 0x7E00);
}

/// A picture's layers of every kind.
Layers layers_of(const Image& image) {
  Layers layers{image.width, image.height, {}, {}};
  const std::size_t count = std::size_t{image.width} * image.height;
  std::vector<float> alpha(count), depth(count);
  std::vector<std::uint32_t> ids(count);
  for (std::size_t i = 0; i < count; ++i) {
    alpha[i] = static_cast<float>(i % 5) / 4;
    depth[i] = 1 + static_cast<float>(i) / 7;
    ids[i] = 0xFFFFFFFFu - static_cast<std::uint32_t>(i);
  }
  layers.channels = {
      {"A", alpha, true}, {"Z", depth}, {"objectId.X", ids}, {"normal.X", depth, true}};
  layers.notes = {{"cryptomatte/0123456/name", "CryptoObject"}};
  return layers;
}

TEST_F(WriteImage, ExrHasEveryChannelWithItsKindOfNumber) {
  for (const auto& [width, height] : {std::pair{37u, 21u}, {1u, 1u}, {5u, 16u}, {300u, 33u}}) {
    const Image image = light(width, height);
    const Layers layers = layers_of(image);
    const std::string file = path("a.exr");
    ASSERT_TRUE(write_image(image, layers, file));
    EXPECT_EQ(exr_channel<float>(file, "Z"), *layers.find("Z")->floats());
    EXPECT_EQ(exr_channel<std::uint32_t>(file, "objectId.X"), *layers.find("objectId.X")->ids());
    const std::vector<float> normals = exr_channel<float>(file, "normal.X");
    for (std::size_t i = 0; i < normals.size(); ++i)
      ASSERT_NEAR(normals[i], (*layers.find("Z")->floats())[i], normals[i] * 0x1p-11f);
    const std::vector<float> red = exr_channel<float>(file, "R");
    for (std::size_t i = 3; i < red.size(); ++i)
      ASSERT_NEAR(red[i], image.pixels[3 * i], 0x1p-11f * 1.5f);

    Imf::InputFile opened(file.c_str());
    const Imf::ChannelList& channels = opened.header().channels();
    EXPECT_EQ(channels.findChannel("R")->type, Imf::HALF);
    EXPECT_EQ(channels.findChannel("A")->type, Imf::HALF);
    EXPECT_EQ(channels.findChannel("Z")->type, Imf::FLOAT);
    EXPECT_EQ(channels.findChannel("objectId.X")->type, Imf::UINT);
    EXPECT_EQ(opened.header().compression(), Imf::ZIP_COMPRESSION);
    EXPECT_EQ(opened.header()
                  .findTypedAttribute<Imf::StringAttribute>("cryptomatte/0123456/name")
                  ->value(),
              "CryptoObject");
    EXPECT_TRUE(read_image(file));  // our own reader takes the colours out of it
  }
}

TEST_F(WriteImage, PngAndExrAgreeThroughTheTransferCurve) {
  Image image = light();
  image.pixels[4] = 0.25f;
  const Image stored = back(image, "a.png", {.bits = 16}).image;
  const Image linear = back(image, "a.exr", {.bits = 32}).image;
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const double clamped = std::clamp(static_cast<double>(linear.pixels[i]), 0.0, 1.0);
    ASSERT_NEAR(static_cast<double>(stored.pixels[i]), encode_srgb(clamped), 0.6 / 65535) << i;
  }
}

TEST_F(WriteImage, PngAlphaIsNotMultipliedIntoColors) {
  // Half covered by light of 0.8: 0.4 of it comes. The reader lays it over black again.
  Image image(300, 2);
  std::fill(image.pixels.begin(), image.pixels.end(), 0.4f);
  image.pixels[3] = 0.7f;  // where nothing is covered there is no color, whatever the picture says
  Layers layers{300, 2, {{"A", std::vector<float>(600, 0.5f), true}}, {}};
  std::get<std::vector<float>>(layers.channels[0].values)[1] = 0;
  for (const int bits : {8, 16}) {
    const ReadImage read =
        back(image, "a.png", {.bits = bits, .transfer = Transfer::linear}, layers);
    EXPECT_TRUE(read.alpha);
    const double most = bits == 16 ? 65535 : 255;
    for (const std::size_t pixel : {0u, 2u, 255u, 256u, 299u, 599u})
      EXPECT_NEAR(static_cast<double>(read.image.pixels[3 * pixel]),
                  std::round(0.8 * most) / most * std::round(0.5 * most) / most, 1e-6)
          << pixel;
    EXPECT_EQ(read.image.pixels[3], 0);
  }
}

TEST_F(WriteImage, SamePictureSameBytes) {
  const Image image = light(300, 200);
  for (const PictureFormat& format : picture_formats())
    for (const std::string_view ending : format.endings) {
      const Layers layers = format.layers ? layers_of(image) : Layers();
      const std::string a = path("a" + std::string(ending)), b = path("b" + std::string(ending));
      ASSERT_TRUE(write_image(image, layers, a, {.threads = 1}));
      ASSERT_TRUE(write_image(image, layers, b, {.threads = 3}));
      EXPECT_EQ(bytes_of(a), bytes_of(b)) << ending;
      EXPECT_GT(bytes_of(a).size(), 100u) << ending;
    }
}

TEST_F(WriteImage, SaysWhatCannotBeWritten) {
  const Layers alpha{2, 1, {{"A", std::vector<float>(2)}}, {}};
  const Layers depth{2, 1, {{"Z", std::vector<float>(2)}}, {}};
  EXPECT_EQ(error("a.tif"),
            "a.tif: error: its ending is none of a kind of picture that is written\n  known are "
            ".png, .exr, .ppm, .pfm, .jpg, .jpeg, .hdr\n");
  EXPECT_EQ(error("a.jpg", {.bits = 16}),
            "a.jpg: error: cannot be written: JPEG has 8 bits a value, not 16\n");
  EXPECT_EQ(error("a.exr", {.bits = 8}),
            "a.exr: error: cannot be written: OpenEXR has 16 or 32 bits a value, not 8\n");
  EXPECT_EQ(error("a.jpg", {}, alpha), "a.jpg: error: cannot be written: JPEG holds no alpha\n");
  EXPECT_EQ(error("a.png", {}, depth),
            "a.png: error: cannot be written: PNG holds no layers beside the colours\n");
  EXPECT_EQ(error("a.pfm", {.tone = {ToneCurve::filmic}}),
            "a.pfm: error: cannot be written: PFM holds linear light, which is not tone-mapped\n");
  EXPECT_EQ(error("a.png", {.tone = {ToneCurve::clamp, 1000}}),
            "a.png: error: cannot be written: the exposure is not from -100 to 100 stops\n");
  EXPECT_EQ(error("a.png", {.tone = {ToneCurve::reinhard, 0, -1}}),
            "a.png: error: cannot be written: white is below 0\n");
  EXPECT_EQ(error("a.jpg", {.jpeg_quality = 101}),
            "a.jpg: error: cannot be written: a JPEG's quality is not from 1 to 100\n");
  EXPECT_EQ(error("a.exr", {}, depth, Image(3, 1)),
            "a.exr: error: cannot be written: the channel Z is of another size than the "
            "picture\n");
  EXPECT_EQ(error("a.exr", {}, {2, 1, {{"R", std::vector<float>(2)}}, {}}),
            "a.exr: error: cannot be written: there are two channels called 'R'\n");
  EXPECT_EQ(error("a.png", {}, {}, Image()),
            "a.png: error: cannot be written: a picture without pixels\n");
  EXPECT_EQ(error(path("none/a.ppm")),
            path("none/a.ppm") +
                ": error: cannot be written: No such file or directory\n  does "
                "its folder exist?\n");
  EXPECT_FALSE(fs::exists("a.tif") || fs::exists("a.jpg") || fs::exists("a.png"));
}

TEST_F(WriteImage, FailureLeavesTheOldFile) {
  // libjpeg finds out late that a side is too long for it.
  std::ofstream(path("a.jpg")) << "old";
  EXPECT_EQ(error(path("a.jpg"), {}, {}, Image(70000, 1)),
            path("a.jpg") +
                ": error: cannot be written: Maximum supported image dimension is 65500 pixels\n");
  EXPECT_EQ(bytes_of(path("a.jpg")), "old");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1);
  if (fs::exists("/dev/full")) {
    for (const PictureFormat& format : picture_formats()) {
      fs::create_symlink("/dev/full", path("full" + std::string(format.endings[0])));
      EXPECT_EQ(error(path("full" + std::string(format.endings[0])), {}, {}, light()),
                path("full" + std::string(format.endings[0])) +
                    ": error: cannot be written: No space left on device\n");
    }
  }
}

TEST(PictureFormats, AreFoundByNamesInAnyCase) {
  EXPECT_EQ(picture_format_of("a.PnG")->name, "PNG");
  EXPECT_EQ(picture_format_of("a.b/c.JPEG")->name, "JPEG");
  EXPECT_EQ(picture_format_of("-")->name, "PNG");
  EXPECT_EQ(picture_format_of("name")->name, "PNG");
  EXPECT_EQ(picture_format_of("/dev/stdout")->name, "PNG");
  EXPECT_FALSE(picture_format_of("a.gif"));
}

}  // namespace
}  // namespace zraka
