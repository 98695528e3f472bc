// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <climits>
#include <cmath>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>

#include "core/base/field_archive.h"
#include "core/base/text.h"
#include "core/garment/fabric.h"
#include "core/geometry/placement.h"
#include "core/marker/marker_plan.h"
#include "core/project/piece_settings.h"

namespace toile::project_fields {

/// Fields of a project file for markers (layouts on cloth); included in one file.

inline constexpr double kMaxOfCloth = 1e6;       ///< mm
inline constexpr double kFarthestOnCloth = 1e7;  ///< mm, along and across, in both directions
inline constexpr double kMaxMarkerTurn = 6.283185307179586;
inline constexpr int kWorstGrade = 1000;
inline constexpr int kMaxGarments = 200;  ///< same limit as in the window

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

inline constexpr auto kHideZone = [](auto& at, auto& zone) {
    closedLine(at, "outline", zone.outline);
    at.field("grade", zone.grade, 0, kWorstGrade);
};

inline constexpr auto kHide = [](auto& at, auto& hide) {
    at.field("name", hide.name);
    closedLine(at, "outline", hide.outline);
    if (at.kReads || !hide.zones.empty()) {
        at.list("zones", hide.zones, kHideZone);
    }
};

/// Hides are shared in memory, but the file stores each separately.
template <class Fields, class Hides>
void hideList(Fields& at, Hides& hides) {
    if constexpr (Fields::kReads) {
        std::vector<Hide> read;
        at.list("hides", read, kHide);
        for (Hide& hide : read) {
            hides.push_back(std::make_shared<const Hide>(std::move(hide)));
        }
    } else if (!hides.empty()) {
        std::vector<Hide> written;
        written.reserve(hides.size());
        for (const auto& hide : hides) {
            written.push_back(*hide);
        }
        at.list("hides", written, kHide);
    }
}

inline constexpr auto kRepeat = [](auto& at, auto& repeat) {
    at.field("warp", repeat.warp, 0, kMaxOfCloth);
    at.field("weft", repeat.weft, 0, kMaxOfCloth);
    at.point("origin", repeat.origin, kMaxOfCloth);
};

/// Names of seams across which the repeat is matched.
template <class Fields, class Names>
void nameList(Fields& at, const char* key, Names& names) {
    if constexpr (Fields::kReads) {
        at.fields().readEach(key, [&](const JsonDocument& json, const std::string& place) {
            if (json.is_string()) {
                names.push_back(json.template get<std::string>());
            } else {
                at.fields().failAt(place, "must be a text");
            }
        });
    } else if (!names.empty()) {
        at.json()[key] = names;
    }
}

/// The worst grade allowed for a piece.
using GradeOfPiece = std::pair<std::string, int>;

inline constexpr auto kGrade = [](auto& at, auto& grade) {
    at.need("piece");
    at.field("piece", grade.first);
    at.field("grade", grade.second, 1, kWorstGrade);
};

template <class Fields, class Grades>
void gradeList(Fields& at, Grades& grades) {
    if constexpr (Fields::kReads) {
        std::vector<GradeOfPiece> read;
        at.list("grades", read, kGrade);
        grades.insert(read.begin(), read.end());
    } else if (!grades.empty()) {
        const std::vector<GradeOfPiece> written(grades.begin(), grades.end());
        at.list("grades", written, kGrade);
    }
}

inline constexpr auto kKeptCopy = [](auto& at, auto& kept) {
    at.need("piece");
    at.id("piece", kept.copy.piece);
    at.field("number", kept.copy.number, 0, kMaxCopies);
    at.field("sheet", kept.sheet, 0, INT_MAX);
    at.need("offset");
    at.point("offset", kept.placement.offset, kFarthestOnCloth);
    at.field("turn", kept.placement.turn);
    if constexpr (std::decay_t<decltype(at)>::kReads) {  // any number is a valid direction
        kept.placement.turn = wrappedAngle(kept.placement.turn);
    }
    at.field("mirrored", kept.placement.mirrored);
};

/// The plan of one material.
using MarkerOfMaterial = std::pair<std::string, MarkerPlan>;

inline constexpr auto kMarker = [](auto& at, auto& marker) {
    auto& settings = marker.second.settings;
    at.text("material", marker.first);
    at.field("width", settings.width, 0, kMaxClothWidth);
    at.point("sheet", settings.sheet);
    if constexpr (std::decay_t<decltype(at)>::kReads) {
        if (settings.sheet && !(settings.sheet->minCoeff() > 0)) {
            at.fail("sheet", "must be more than 0");
        } else if (settings.sheet && settings.sheet->maxCoeff() > kMaxClothWidth) {
            at.fail("sheet", "must be at most " + shortest(kMaxClothWidth));
        }
    }
    hideList(at, settings.hides);
    at.field("gap", settings.gap, 0, kMaxOfCloth);
    at.field("border", settings.border, 0, kMaxOfCloth);
    at.word("turns", settings.turns, kTurnRuleWords);
    at.field("tolerance", settings.tolerance, 0, kMaxMarkerTurn);
    at.field("isFolded", settings.isFolded);
    if (at.kReads || !(settings.repeat == ClothRepeat{})) {
        at.object("repeat", settings.repeat, kRepeat);
    }
    nameList(at, "matched", settings.matched);
    gradeList(at, settings.grades);
    at.field("garments", settings.garments, 1, kMaxGarments);
    if (at.kReads || !marker.second.kept.empty()) {
        at.list("kept", marker.second.kept, kKeptCopy);
    }
};

}  // namespace toile::project_fields
