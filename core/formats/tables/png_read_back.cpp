// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstdint>
#include <optional>

#include <zlib.h>

#include "core/base/text.h"
#include "core/formats/read_backs.h"

namespace toile {
namespace {

constexpr std::string_view kSignature = "\x89PNG\r\n\x1a\n";
constexpr std::size_t kAroundData = 12;  // bytes: length, type and check of a chunk
constexpr double kMillimetresPerInch = 25.4;

struct PngSize {
    std::uint32_t width = 0, height = 0;  ///< dots
    std::uint32_t dotsPerMetreAcross = 0, dotsPerMetreDown = 0;
};

/// PNG stores the highest byte first.
std::uint32_t numberAt(std::string_view bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t k = 0; k < 4; ++k) {
        value = value << 8 | static_cast<std::uint8_t>(bytes[at + k]);
    }
    return value;
}

/// None if a chunk is cut off or damaged, or the end is missing.
std::optional<PngSize> sizeOf(std::string_view png) {
    if (!png.starts_with(kSignature)) {
        return {};
    }
    PngSize size;
    png.remove_prefix(kSignature.size());
    while (png.size() >= kAroundData) {
        const std::size_t length = numberAt(png, 0);
        if (length > png.size() - kAroundData) {
            return {};
        }
        const std::string_view checked = png.substr(4, 4 + length);
        const std::string_view type = checked.substr(0, 4), data = checked.substr(4);
        const auto check = crc32_z(0, reinterpret_cast<const Bytef*>(checked.data()), length + 4);
        if (check != numberAt(png, 8 + length)) {
            return {};
        }
        if (type == "IHDR" && length >= 8) {
            size.width = numberAt(data, 0);
            size.height = numberAt(data, 4);
        } else if (type == "pHYs" && length == 9 && data[8] == 1) {
            size.dotsPerMetreAcross = numberAt(data, 0);
            size.dotsPerMetreDown = numberAt(data, 4);
        } else if (type == "IEND") {
            return size;
        }
        png.remove_prefix(kAroundData + length);
    }
    return {};
}

}  // namespace

Result<ReadBack> readBackPng(std::string_view bytes, const Drawing& drawing,
                             const PngOptions& options) {
    const std::optional<PngSize> size = sizeOf(bytes);
    if (!size) {
        return notReadBack("the picture", "it is not whole");
    }
    const double perMillimetre = options.dpi / kMillimetresPerInch;
    struct {
        const char* what;
        double is, should;
    } const all[] = {{"dots across", double(size->width), drawing.width * perMillimetre},
                     {"dots down", double(size->height), drawing.height * perMillimetre},
                     {"dots per metre", double(size->dotsPerMetreAcross), 1000 * perMillimetre},
                     {"dots per metre", double(size->dotsPerMetreDown), 1000 * perMillimetre}};
    for (const auto& [what, is, should] : all) {
        if (is != std::round(should)) {
            return notReadBack("the picture", fixed(is, 0) + " " + what + " instead of " +
                                                  fixed(std::round(should), 0));
        }
    }
    return ReadBack{.dots = {static_cast<int>(size->width), static_cast<int>(size->height)}};
}

}  // namespace toile
