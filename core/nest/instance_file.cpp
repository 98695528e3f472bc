// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nest/instance_file.h"

#include <utility>

#include "core/base/file.h"
#include "core/base/json_fields.h"
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

}  // namespace toile
