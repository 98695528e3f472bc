// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nest/nest_writer.h"

#include <algorithm>
#include <array>

#include "core/base/json_fields.h"
#include "core/base/text.h"
#include "core/base/units.h"

namespace toile {
namespace {

/// Light enough for black lines, and distinguishable side by side.
constexpr std::array kItemColours{"#a8c8e8", "#f2c6a0", "#b5d8b0", "#e8b4bc", "#d0c4e6", "#ece2a0",
                                  "#a6d8d4", "#d8c4b0", "#c8d0d8", "#e4c0e0", "#cfe0a4", "#f0b8a4"};
constexpr double kStrokeShare = 0.002;  // of the strip's width

}  // namespace

std::string nestReport(const NestInstance& instance, const NestOptions& options,
                       const NestResult& result) {
    OrderedJson json;
    json["name"] = instance.name;
    json["width"] = instance.width;
    json["length"] = result.length;
    json["use"] = result.use;
    json["rounds"] = result.rounds;
    json["seed"] = options.seed;
    json["gap"] = options.gap;
    json["border"] = options.border;
    json["valid"] = result.valid;
    json["placements"] = OrderedJson::array();
    for (const NestPlacement& placement : result.placements) {
        OrderedJson placed;
        placed["item"] = instance.items[static_cast<std::size_t>(placement.item)].name;
        placed["angle"] = placement.angle / kDegree;
        placed["mirrored"] = placement.mirrored;
        placed["x"] = placement.x;
        placed["y"] = placement.y;
        json["placements"].push_back(std::move(placed));
    }
    return jsonText(json);
}

std::string nestPicture(const NestInstance& instance, const NestResult& result) {
    const std::string length = shortest(result.length), width = shortest(instance.width);
    const std::string stroke = shortest(instance.width * kStrokeShare);
    std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + length +
                      "mm\" height=\"" + width + "mm\" viewBox=\"0 0 " + length + " " + width +
                      "\">\n<rect width=\"" + length + "\" height=\"" + width +
                      "\" fill=\"#ffffff\" stroke=\"#808080\" stroke-width=\"" + stroke +
                      "\"/>\n<g stroke=\"#202020\" stroke-linejoin=\"round\" fill-rule=\"evenodd\" "
                      "stroke-width=\"" +
                      stroke + "\">\n";
    for (const NestPlacement& placement : result.placements) {
        const auto item = static_cast<std::size_t>(placement.item);
        svg += "<path fill=\"";
        svg += kItemColours[item % kItemColours.size()];
        svg += "\" d=\"";
        for (const auto& ring : placedRings(instance.items[item], placement)) {
            for (Eigen::Index k = 0; k < ring.rows(); ++k) {
                svg += k == 0 ? 'M' : 'L';
                svg += shortest(ring(k, 0));
                svg += ',';
                svg += shortest(instance.width - ring(k, 1));
            }
            svg += "Z";
        }
        svg += "\"/>\n";
    }
    return svg + "</g>\n</svg>\n";
}

}  // namespace toile
