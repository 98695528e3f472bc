// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nest/instance_file.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/base/file.h"
#include "core/base/json_fields.h"
#include "core/base/text.h"
#include "core/base/units.h"

namespace toile {
namespace {

using geometry::Polygon;

constexpr double kMaxNumber = 1e7;
constexpr int kMaxCopiesOfItem = 100'000;

/// A list of points; the last point may repeat the first.
Polygon readRing(JsonFields& fields, const JsonDocument& list, const std::string& place) {
    Polygon ring(list.is_array() ? static_cast<Eigen::Index>(list.size()) : 0, 2);
    for (Eigen::Index k = 0; k < ring.rows(); ++k) {
        const auto point = numbersOf(list[static_cast<std::size_t>(k)], 2);
        if (!point) {
            fields.failAt(place + "[" + std::to_string(k) + "]", "must be two numbers");
            return ring;
        }
        ring.row(k) << (*point)[0], (*point)[1];
    }
    if (ring.rows() > 1 && ring.row(0) == ring.row(ring.rows() - 1)) {
        ring.conservativeResize(ring.rows() - 1, 2);
    }
    if (ring.rows() < 3) {
        fields.failAt(place, "must be a list of at least three points");
    }
    return ring;
}

void readShape(JsonFields& shape, std::vector<Polygon>& rings) {
    std::string type;
    shape.need("type");
    shape.read("type", type);
    if (type == "polygon") {
        shape.need("data");
        shape.readObject("data", [&rings](JsonFields& data) {
            if (const JsonDocument* outer = data.need("outer")) {
                rings.push_back(readRing(data, *outer, data.placeOf("outer")));
            }
            data.readEach("inner", [&](const JsonDocument& inner, const std::string& place) {
                rings.push_back(readRing(data, inner, place));
            });
        });
    } else if (type == "simple_polygon") {
        if (const JsonDocument* data = shape.need("data")) {
            rings.push_back(readRing(shape, *data, shape.placeOf("data")));
        }
    } else if (!shape.failed()) {
        shape.fail("type", "must be \"simple_polygon\" or \"polygon\"");
    }
}

NestItem readItem(JsonFields& fields) {
    NestItem item;
    int id = 0;
    fields.read("id", id, 0, kMaxCopiesOfItem);
    item.name = std::to_string(id);
    fields.need("demand");
    fields.read("demand", item.demand, 0, kMaxCopiesOfItem);
    item.tolerance = kPi;
    if (const JsonDocument* angles = fields.find("allowed_orientations");
        angles && !angles->is_null()) {
        item.angles.clear();
        item.tolerance = 0;
        const auto degrees = numbersOf(*angles, angles->size());
        if (!angles->is_array() || !degrees || degrees->empty()) {
            fields.fail("allowed_orientations", "must be a list of numbers");
        } else {
            for (const double angle : *degrees) {
                item.angles.push_back(angle * kDegree);
            }
        }
    }
    fields.need("shape");
    fields.readObject("shape", [&item](JsonFields& shape) { readShape(shape, item.rings); });
    return item;
}

}  // namespace

Result<NestInstance> parseNestInstance(std::string_view text, const std::string& name) {
    const auto json = parseJson(text, name, ErrorCode::MalformedFile);
    if (!json) {
        return json.error();
    }
    NestInstance instance;
    JsonFaults faults;
    {
        JsonFields fields(*json, "", faults);
        fields.read("name", instance.name);
        fields.need("strip_height");
        fields.read("strip_height", instance.width, 1e-6, kMaxNumber);
        fields.need("items");
        fields.readObjects(
            "items", [&instance](JsonFields& item) { instance.items.push_back(readItem(item)); });
    }
    if (!faults.first.empty()) {
        return Error{ErrorCode::MalformedFile, Subject::file(name), faults.first};
    }
    return instance;
}

Result<NestInstance> readNestInstance(const std::filesystem::path& path) {
    const auto text = readFile(path);
    return text ? parseNestInstance(*text, pathText(path)) : text.error();
}

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
