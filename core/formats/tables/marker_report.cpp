// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "core/base/units.h"
#include "core/base/version.h"
#include "core/formats/json.h"
#include "core/formats/writers.h"

namespace toile {
namespace {

constexpr int kMarkerVersion = 1;  // increased when a field changes its meaning or is removed

Json copiesJson(const Pattern& pattern, const ClothMarker& marker) {
    Json copies = Json::array();
    for (const LaidCopy& copy : marker.copies) {
        const PatternPiece& piece = pattern.pieces[static_cast<std::size_t>(copy.piece)];
        copies.push_back({{"piece", text(piece.name)},
                          {"number", copy.key.number},
                          {"mirrored", copy.placement.mirrored},
                          {"on_fold", piece.cutAs == CutAs::OnFold},
                          {"kept", copy.isKept},
                          {"sheet", copy.sheet},
                          {"yield", copy.yield},
                          {"angle", number(copy.placement.turn / kDegree)},
                          {"x", number(copy.placement.offset.x())},
                          {"y", number(copy.placement.offset.y())}});
    }
    return copies;
}

Json markerJson(const MadeMarker& made, std::optional<double> minutesPerMetre) {
    const Pattern& pattern = *made.pattern;
    const ClothMarker& marker = made.marker;
    const MarkerFigures figures = markerFigures(pattern, marker);
    Json notes = Json::array();
    for (const Wording& note : marker.notes) {
        notes.push_back(text(note));
    }
    Json json{{"material", textOrNull(marker.material)},
              {"garments", made.settings.garments},
              {"gap", number(made.settings.gap)},
              {"border", number(made.settings.border)},
              {"folded", made.settings.isFolded},
              {"seed", made.settings.seed},
              {"width", number(marker.width)},
              {"length", number(marker.length)},
              {"sheets", marker.isRoll ? Json(nullptr) : Json(marker.sheets)},
              {"use", number(marker.use)},
              {"rounds", marker.rounds},
              {"optimal", marker.isOptimal},
              {"pieces", figures.copies},
              {"seam_metres", number(figures.seamMetres)},
              {"cut_metres", number(figures.cutMetres)},
              {"notches", figures.notches}};
    json["minutes"] = minutesPerMetre ? number(*minutesPerMetre * figures.seamMetres) : Json();
    json["notes"] = std::move(notes);
    json["copies"] = copiesJson(pattern, marker);
    return json;
}

}  // namespace

std::string writeMarkers(const std::vector<MadeMarker>& markers,
                         std::optional<double> minutesPerMetre) {
    double used = 0, cloth = 0, length = 0;
    int rounds = 0;
    Json all = Json::array();
    for (const MadeMarker& made : markers) {
        const ClothMarker& marker = made.marker;
        cloth += marker.clothArea;
        used += marker.use * marker.clothArea;
        length += marker.length;
        rounds = std::max(rounds, marker.rounds);
        all.push_back(markerJson(made, minutesPerMetre));
    }
    const Json json{{"version", kMarkerVersion},
                    {"toile", text(version())},
                    {"name", text(markers.front().pattern->name)},
                    {"use", number(cloth > 0 ? used / cloth : 0)},
                    {"length", number(length)},
                    {"rounds", rounds},
                    {"markers", std::move(all)}};
    return jsonText(json);
}

}  // namespace toile
