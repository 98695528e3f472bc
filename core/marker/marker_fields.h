// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/base/json_fields.h"
#include "core/base/setting.h"
#include "core/base/text.h"
#include "core/garment/fabric.h"
#include "core/marker/marker_settings.h"

namespace toile {

/// Descriptions of the settings of markers (layouts on cloth), for project files and forms
/// (core/base/field_archive.h).

inline constexpr double kMaxOfCloth = 1e6;       ///< mm
inline constexpr double kFarthestOnCloth = 1e7;  ///< mm, along and across, in both directions
inline constexpr double kMaxMarkerTurn = 6.283185307179586;
inline constexpr int kWorstGrade = 1000;
inline constexpr int kMaxGarments = 200;  ///< same limit as in the window

inline constexpr const char* kTurnRuleNames[] = {TR("Both ways"), TR("One way"), TR("Free")};
inline constexpr Word<TurnRule> kTurnRuleWords[] = {
    {TurnRule::HalfTurns, "halfTurns"}, {TurnRule::OneWay, "oneWay"}, {TurnRule::Free, "free"}};

/// Points as pairs of numbers, at least three.
template <class Fields, class Line>
void closedLine(Fields& at, const char* key, Line& line) {
    at.need(key);
    if constexpr (Fields::kReads) {
        std::vector<std::vector<double>> points;
        at.fields().readEach(key, [&](const JsonDocument& json, const std::string& place) {
            auto numbers = numbersOf(json, 2);
            if (!numbers) {
                at.fields().failAt(place, "must be a list of 2 numbers");
                return;
            }
            if (std::max(std::abs((*numbers)[0]), std::abs((*numbers)[1])) > kFarthestOnCloth) {
                at.fields().failAt(place, "must be numbers from " + shortest(-kFarthestOnCloth) +
                                              " to " + shortest(kFarthestOnCloth));
                return;
            }
            points.push_back(*std::move(numbers));
        });
        line.resize(static_cast<Eigen::Index>(points.size()), 2);
        for (std::size_t k = 0; k < points.size(); ++k) {
            line.row(static_cast<Eigen::Index>(k)) << points[k][0], points[k][1];
        }
        if (points.size() < 3) {
            at.fail(key, "must have three points at least");
        }
    } else {
        auto& list = at.json()[key] = OrderedJson::array();
        for (Eigen::Index k = 0; k < line.rows(); ++k) {
            list.push_back({line(k, 0), line(k, 1)});
        }
    }
}

inline constexpr auto kHideZoneFields = [](auto& at, auto& zone) {
    closedLine(at, "outline", zone.outline);
    at.field("grade", zone.grade, 0, kWorstGrade);
};

inline constexpr auto kHideFields = [](auto& at, auto& hide) {
    at.field("name", hide.name);
    closedLine(at, "outline", hide.outline);
    if (at.kReads || !hide.zones.empty()) {
        at.list("zones", hide.zones, kHideZoneFields);
    }
};

/// Hides are shared in memory, but the file stores each separately.
template <class Fields, class Hides>
void hideList(Fields& at, Hides& hides) {
    if constexpr (Fields::kReads) {
        std::vector<Hide> read;
        at.list("hides", read, kHideFields);
        for (Hide& hide : read) {
            hides.push_back(std::make_shared<const Hide>(std::move(hide)));
        }
    } else if (!hides.empty()) {
        std::vector<Hide> written;
        written.reserve(hides.size());
        for (const auto& hide : hides) {
            written.push_back(*hide);
        }
        at.list("hides", written, kHideFields);
    }
}

inline constexpr auto kRepeatFields = [](auto& at, auto& repeat) {
    at.field(Setting{"warp", TR("Repeat a&long"), TR("Repeat along the warp"),
                     TR("Distance of stripes along the warp; 0: no stripes")},
             repeat.warp, 0, kMaxOfCloth);
    at.field(Setting{"weft", TR("Repeat acro&ss"), TR("Repeat across the warp"),
                     TR("Distance of stripes across the warp; 0: no stripes")},
             repeat.weft, 0, kMaxOfCloth);
    at.point("origin", repeat.origin, kMaxOfCloth);
};

/// The worst grade allowed for a piece.
using GradeOfPiece = std::pair<std::string, int>;

inline constexpr auto kGradeFields = [](auto& at, auto& grade) {
    at.need("piece");
    at.field("piece", grade.first);
    at.field("grade", grade.second, 1, kWorstGrade);
};

template <class Fields, class Grades>
void gradeList(Fields& at, Grades& grades) {
    if constexpr (Fields::kReads) {
        std::vector<GradeOfPiece> read;
        at.list("grades", read, kGradeFields);
        grades.insert(read.begin(), read.end());
    } else if (!grades.empty()) {
        const std::vector<GradeOfPiece> written(grades.begin(), grades.end());
        at.list("grades", written, kGradeFields);
    }
}

inline constexpr auto kMarkerSettingsFields = [](auto& at, auto& settings) {
    at.field(Setting{"width", TR("&Width"), TR("Width of the marker"),
                     TR("From selvedge to selvedge; default: width of the fabric"), ""},
             settings.width, 0, kMaxClothWidth);
    at.point("sheet", settings.sheet);
    if constexpr (std::decay_t<decltype(at)>::kReads) {
        if (settings.sheet && !(settings.sheet->minCoeff() > 0)) {
            at.fail("sheet", "must be more than 0");
        } else if (settings.sheet && settings.sheet->maxCoeff() > kMaxClothWidth) {
            at.fail("sheet", "must be at most " + shortest(kMaxClothWidth));
        }
    }
    hideList(at, settings.hides);
    at.field(Setting{"gap", TR("Ga&p"), TR("Gap of the marker"),
                     TR("Smallest distance between two pieces")},
             settings.gap, 0, kMaxOfCloth);
    at.field(Setting{"border", TR("&Border"), TR("Border of the marker"),
                     TR("Smallest distance to the edges of the cloth")},
             settings.border, 0, kMaxOfCloth);
    at.word(Setting{"turns", TR("Direc&tion"), TR("Direction of pieces"),
                    TR("Both ways along the warp, one way for nap and directional prints, or free "
                       "on cloth without a grain"),
                    nullptr, kTurnRuleNames},
            settings.turns, kTurnRuleWords);
    at.field(Setting{.key = "tolerance",
                     .title = TR("Grain tol&erance"),
                     .name = TR("Grain tolerance"),
                     .help = TR("Maximum rotation of a piece off the grain, to both sides"),
                     .quantity = Quantity::Angle},
             settings.tolerance, 0, kMaxMarkerTurn);
    at.field(Setting{"isFolded", TR("F&olded lengthwise"), TR("Folded cloth"),
                     TR("Two layers, right sides together: pairs are cut at once, and symmetric "
                        "pieces on the fold")},
             settings.isFolded);
    if (at.kReads || !(settings.repeat == ClothRepeat{})) {
        at.object("repeat", settings.repeat, kRepeatFields);
    }
    at.texts("matched", settings.matched);
    gradeList(at, settings.grades);
    at.field(Setting{.key = "garments",
                     .title = TR("&Garments"),
                     .name = TR("Garments of the marker"),
                     .help = TR("Number of garments in the marker"),
                     .quantity = Quantity::Count},
             settings.garments, 1, kMaxGarments);
};

}  // namespace toile
