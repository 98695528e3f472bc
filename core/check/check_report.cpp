// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/text.h"
#include "core/base/version.h"
#include "core/check/ready_to_cut.h"
#include "core/formats/json.h"

namespace toile {
namespace {

constexpr int kCheckVersion = 1;  // increase it when a field changes its meaning or is removed

std::string_view unitName(Figure::Unit unit) {
    switch (unit) {
        case Figure::Unit::Length:
            return "mm";
        case Figure::Unit::Angle:
            return "radians";
        case Figure::Unit::Count:
            return "count";
        default:
            return "fraction";
    }
}

Json placeJson(const FindingPlace& place) {
    return {{"position",
             {number(place.position.x()), number(place.position.y()), number(place.position.z())}},
            {"flat", {number(place.flat.x()), number(place.flat.y())}}};
}

Json findingJson(const Garment& garment, const Finding& finding) {
    Json pieces = Json::array();
    for (const int piece : finding.pieces) {
        pieces.push_back(garment.pieces[static_cast<std::size_t>(piece)]->name);
    }
    Json figures = Json::array();
    for (const Figure& figure : finding.figures) {
        figures.push_back({{"value", number(figure.value)}, {"unit", text(unitName(figure.unit))}});
    }
    return {{"kind", text(name(finding.kind))},
            {"severity", text(name(finding.severity))},
            {"code", finding.error ? text(name(finding.error->code)) : Json(nullptr)},
            {"where", textOrNull(finding.subject.name)},
            {"pieces", std::move(pieces)},
            {"seam", finding.seam < 0 ? Json(nullptr) : Json(finding.subject.name)},
            {"place", finding.place ? placeJson(*finding.place) : Json(nullptr)},
            {"figures", std::move(figures)},
            {"message", sentence(finding)}};
}

}  // namespace

std::string writeReadiness(const Garment& garment, const Readiness& readiness) {
    Json json{{"version", kCheckVersion},
              {"toile", text(version())},
              {"verdict", text(name(readiness.verdict()))},
              {"faults", readiness.count(Severity::Fault)},
              {"doubts", readiness.count(Severity::Doubt)},
              {"notes", readiness.count(Severity::Note)}};
    json["findings"] = Json::array();
    for (const Finding& finding : readiness.findings) {
        json["findings"].push_back(findingJson(garment, finding));
    }
    json["cloth"] = Json::array();
    for (const ClothNeed& need : readiness.cloth) {
        json["cloth"].push_back({{"material", textOrNull(need.material)},
                                 {"length_mm", number(need.length)},
                                 {"across_mm", number(need.across)},
                                 {"width_mm", number(need.width)},
                                 {"fits", need.fits()}});
    }
    return jsonText(json);
}

}  // namespace toile
