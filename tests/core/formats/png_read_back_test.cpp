// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdint>

#include <gtest/gtest.h>
#include <zlib.h>

#include "core/formats/read_backs.h"

namespace toile {
namespace {

std::string bigEndian(std::uint32_t value) {
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8) {
        bytes += static_cast<char>(value >> shift & 0xff);
    }
    return bytes;
}

std::string chunk(const std::string& type, const std::string& data) {
    const std::string checked = type + data;
    const auto check =
        crc32(0, reinterpret_cast<const Bytef*>(checked.data()), static_cast<uInt>(checked.size()));
    return bigEndian(static_cast<std::uint32_t>(data.size())) + checked +
           bigEndian(static_cast<std::uint32_t>(check));
}

/// A picture without its dots, of which nothing is read.
std::string png(std::uint32_t width, std::uint32_t height, std::uint32_t perMetre) {
    return "\x89PNG\r\n\x1a\n" +
           chunk("IHDR", bigEndian(width) + bigEndian(height) + std::string("\x08\x02\0\0\0", 5)) +
           chunk("pHYs", bigEndian(perMetre) + bigEndian(perMetre) + '\x01') +
           chunk("IDAT", "dots") + chunk("IEND", "");
}

/// 4 x 8 inches.
Drawing page() {
    Drawing drawing;
    drawing.width = 101.6;
    drawing.height = 203.2;
    return drawing;
}

constexpr PngOptions kDots{.dpi = 100};

TEST(PngReadBack, SaysTheSizeOfAPicture) {
    const auto found = readBackPng(png(400, 800, 3937), page(), kDots);
    ASSERT_TRUE(found) << found.error().detail;
    EXPECT_EQ(readBackSentence(*found), "read back: 400 x 800 dots");
}

TEST(PngReadBack, FindsAnotherSizeAndAnotherScale) {
    EXPECT_EQ(readBackPng(png(401, 800, 3937), page(), kDots).error().detail,
              "the picture: 401 dots across instead of 400");
    EXPECT_EQ(readBackPng(png(400, 799, 3937), page(), kDots).error().detail,
              "the picture: 799 dots down instead of 800");
    EXPECT_EQ(readBackPng(png(400, 800, 2835), page(), kDots).error().detail,
              "the picture: 2835 dots per metre instead of 3937");
}

TEST(PngReadBack, RefusesWhatIsCutOffOrDamagedAnywhere) {
    const std::string whole = png(400, 800, 3937);
    for (std::size_t length = 0; length < whole.size(); ++length) {
        EXPECT_FALSE(readBackPng(whole.substr(0, length), page(), kDots)) << length;
    }
    for (std::size_t at = 0; at < whole.size(); ++at) {
        std::string damaged = whole;
        damaged[at] = static_cast<char>(damaged[at] ^ 0x10);
        EXPECT_FALSE(readBackPng(damaged, page(), kDots)) << at;
    }
}

}  // namespace
}  // namespace toile
