// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <climits>
#include <cmath>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/assemble/seams_file.h"
#include "core/base/field_archive.h"
#include "core/base/text.h"
#include "core/flatten/base/flat_piece.h"
#include "core/garment/fabric.h"
#include "core/geometry/placement.h"
#include "core/marker/marker_settings.h"
#include "core/pattern/trueing.h"
#include "core/project/piece_settings.h"
#include "core/project/project.h"
#include "core/prove/proof_settings.h"

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
                at.fields().failAt(place, "must be a string");
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

/// Fields of a project file for the proof; included in one file.

inline constexpr auto kStiffness = [](auto& at, auto& stated) {
    at.field("warp", stated.warp, kMinStretch, kMaxStretch);
    at.field("weft", stated.weft, kMinStretch, kMaxStretch);
    at.field("shear", stated.shear, kMinShear, kMaxShear);
    at.field("bending", stated.bending, 0, kMaxBending);
    at.field("weight", stated.weight, 0, kMaxClothWeight);
};

/// Writes values that differ from the defaults, except the body's file, which depends on the
/// location of the project, and the threads, which depend on the machine.
inline constexpr auto kProof = [](auto& at, auto& plan) {
    const ProofPlan usual;
    auto& settings = plan.settings;
    const auto field = [&at](const char* key, auto& value, const auto& unstated, auto... limits) {
        if (at.kReads || !(value == unstated)) {
            at.field(key, value, limits...);
        }
    };
    if (at.kReads || plan.sewn != usual.sewn) {
        at.word("sewn", plan.sewn, kSewnPatternWords);
    }
    at.field("bodyUnit", plan.bodyUnit);
    field("edge", settings.edge, usual.settings.edge, kMinProofEdge, kMaxProofEdge);
    field("pressure", settings.pressure, usual.settings.pressure, -kMaxPressure, kMaxPressure);
    field("gravity", settings.hasGravity, usual.settings.hasGravity);
    field("selfContact", settings.touchesItself, usual.settings.touchesItself);
    field("thickness", settings.thickness, usual.settings.thickness, kMinThickness, kMaxThickness);
    if (at.kReads || !(settings.stiffness == StatedStiffness{})) {
        at.object("stiffness", settings.stiffness, kStiffness);
    }
};

/// Fields of a project file, one function per type; included in one file.

inline constexpr double kMaxStrain = 10;
inline constexpr int kMaxColour = 1000000;
inline constexpr double kMaxTurns = 2;   ///< around a closed line
inline constexpr double kMaxTurn = 1e6;  ///< radians: beyond, the sine of a double is no direction

inline constexpr auto kScanSteps = [](auto& at, auto& steps) {
    at.field("dropDebris", steps.dropDebris);
    at.field("largestHole", steps.largestHole, 0, kMaxPreparedLength);
    at.field("smoothing", steps.smoothing, 0, kMaxPreparedLength);
    at.field("edgeLength", steps.edgeLength, 0, kMaxPreparedLength);
};

inline constexpr auto kPreparation = [](auto& at, auto& preparation) {
    at.word("as", preparation.as, kFileKindWords);
    at.word("surface", preparation.surface, kShellSurfaceWords);
    at.object("scan", preparation.scan, kScanSteps);
    at.field("weldDistance", preparation.weldDistance, 0, kMaxPreparedLength);
    at.field("onlyLayer", preparation.onlyLayer, 0, INT_MAX);
    at.field("isHalf", preparation.isHalf);
    if (at.kReads || preparation.isTurned) {
        at.field("isTurned", preparation.isTurned);
    }
};

inline constexpr auto kReading = [](auto& at, auto& loading) {
    at.field("unit", loading.unit);
    at.word("up", loading.up, R"("y" or "z")", parseUpAxis);
    at.word("split", loading.split,
            R"("auto", "components", "objects", "groups", "materials", "uv" or "seams")",
            parseSplitMode);
    at.field("weld", loading.weld);
    if (at.kReads || loading.closeSlits) {
        at.field("closeSlits", loading.closeSlits);
    }
    if (at.kReads || !(loading.preparing == Preparation{})) {
        at.object("preparing", loading.preparing, kPreparation);
    }
    at.field("strict", loading.strict);
    at.field("autoCut", loading.autoCut);
    if (at.kReads || loading.cutStyle != CutStyle::Topology) {
        at.word("cutStyle", loading.cutStyle, kCutStyleWords);
    }
    if (at.kReads || loading.isFrontSwapped) {
        at.field("isFrontSwapped", loading.isFrontSwapped);
    }
    if (at.kReads || loading.enoughStrain) {
        at.field("enoughStrain", loading.enoughStrain, 0, kMaxStrain);
    }
};

inline constexpr auto kKnownPiece = [](auto& at, auto& piece) {
    at.need("id");
    at.id("id", piece.id);
    at.field("file", piece.file, 0, INT_MAX);
    at.field("name", piece.name);
    at.point("centre", piece.centre);
    at.field("area", piece.area, 0);
};

inline constexpr auto kStretch = [](auto& at, auto& stretch) {
    at.need("line");
    at.id("line", stretch.line);
    at.field("from", stretch.from, -kMaxTurns, kMaxTurns);
    at.field("to", stretch.to, -kMaxTurns, kMaxTurns);
};

inline constexpr auto kSeamPart = [](auto& at, auto& part) {
    at.field("from", part.from, 0, 1);
    at.field("to", part.to, 0, 1);
    if (!(part.from < part.to)) {
        at.fail("to", "must be more than \"from\"");
    }
};

inline constexpr auto kSeamSettings = [](auto& at, auto& chosen) {
    at.need("left");
    at.object("left", chosen.place.left, kStretch);
    if (at.kReads || chosen.place.right.line) {
        at.object("right", chosen.place.right, kStretch);
    }
    at.field("ease", chosen.ease, -1, kMaxEase);
    if (chosen.ease && *chosen.ease <= -1) {
        at.fail("ease", "must be more than -1");
    }
    at.object("drawn", chosen.drawn, kSeamPart);
    at.text("name", chosen.name);
};

inline constexpr auto kFairing = [](auto& at, auto& fairing) {
    at.field("tolerance", fairing.tolerance, kMinFairTolerance, kMaxFairTolerance);
    at.field("smoothing", fairing.smoothing, kMinSmoothing, kMaxSmoothing);
    at.field("fixed", fairing.isFixed);
};

inline constexpr auto kSegment = [](auto& at, auto& chosen) {
    at.need("place");
    at.object("place", chosen.place, kStretch);
    at.field("length", chosen.length, kMinSegmentLength, kMaxSegmentLength);
    at.field("tolerance", chosen.tolerance, kMinFairTolerance, kMaxFairTolerance);
    at.field("straight", chosen.straight);
    at.field("allowance", chosen.allowance, 0, kMaxAllowance);
    at.word("corner", chosen.corner, kCornerRuleWords);
    at.field("extension", chosen.extension, kMinStrip, kMaxStrip);
};

inline constexpr auto kTurnPoint = [](auto& at, auto& chosen) {
    at.need("line");
    at.id("line", chosen.line);
    at.field("at", chosen.at, -kMaxTurns, kMaxTurns);
    at.field("reversed", chosen.reversed);
    at.field("turns", chosen.turns);
};

inline constexpr auto kSeamEnd = [](auto& at, auto& chosen) {
    at.need("left");
    at.object("left", chosen.seam.left, kStretch);
    if (at.kReads || chosen.seam.right.line) {
        at.object("right", chosen.seam.right, kStretch);
    }
    at.field("atEnd", chosen.atEnd);
    at.field("trued", chosen.trued);
};

inline constexpr auto kAllowance = [](auto& at, auto& widths) {
    at.field("seam", widths.seam, 0, kMaxAllowance);
    at.field("hem", widths.hem, 0, kMaxAllowance);
};

inline constexpr auto kNotch = [](auto& at, auto& chosen) {
    at.need("line");
    at.id("line", chosen.line);
    at.field("at", chosen.at, -kMaxTurns, kMaxTurns);
    at.field("reversed", chosen.reversed);
    at.field("isThere", chosen.isThere);
    at.field("count", chosen.count, 1, 2);
};

inline constexpr auto kNotches = [](auto& at, auto& rules) {
    at.field("automatic", rules.automatic);
    at.word("form", rules.form, kNotchFormWords);
    at.field("depth", rules.depth, kMinNotchDepth, kMaxNotchDepth);
    at.list("notches", rules.notches, kNotch);
};

inline constexpr auto kDart = [](auto& at, auto& chosen) {
    at.need("left");
    at.object("left", chosen.seam.left, kStretch);
    at.object("right", chosen.seam.right, kStretch);
    at.field("intake", chosen.intake, kMinIntake, kMaxIntake);
    at.word("lay", chosen.lay, kDartLayWords);
};

inline constexpr auto kFacing = [](auto& at, auto& facing) {
    at.need("edges");
    at.text("name", facing.name);
    at.list("edges", facing.edges, kStretch);
    at.field("width", facing.width, kMinStrip, kMaxStrip);
};

inline constexpr auto kInternalLine = [](auto& at, auto& line) {
    at.need("points");
    at.text("name", line.name);
    at.list("points", line.points, [](auto& in, auto& point) {
        in.need("at");
        in.point("at", point);
    });
    at.field("closed", line.closed);
};

inline constexpr auto kLabelTexts = [](auto& at, auto& label) {
    at.text("size", label.size);
    at.text("date", label.date);
};

inline constexpr auto kLines = [](auto& at, auto& lines) {
    at.object("fairing", lines.fairing, kFairing);
    at.field("trueBelow", lines.trueBelow, 0, kMaxKink);
    at.word("mirror", lines.mirror, kMirrorWords);
    at.list("segments", lines.segments, kSegment);
    at.list("turnPoints", lines.turnPoints, kTurnPoint);
    at.list("seamEnds", lines.seamEnds, kSeamEnd);
    at.object("allowance", lines.allowance, kAllowance);
    at.object("notches", lines.notches, kNotches);
    at.word("grain", lines.grain, kGrainRuleWords);
    const auto list = [&at](const char* name, auto& things, const auto& describe) {
        if (at.kReads || !things.empty()) {
            at.list(name, things, describe);
        }
    };
    list("darts", lines.darts, kDart);
    list("facings", lines.facings, kFacing);
    list("internalLines", lines.internalLines, kInternalLine);
    if (at.kReads || !(lines.label == LabelTexts{})) {
        at.object("label", lines.label, kLabelTexts);
    }
};

inline constexpr auto kFlattening = [](auto& at, auto& options) {
    at.word("method", options.method, "the name of a method", parseMethod);
    at.word("quality", options.quality, kQualityWords);
    at.word("boundarySolver", options.boundarySolver, R"("newton" or "slcp")", parseBoundarySolver);
    at.word("freeBoundary", options.freeBoundary, kFreeBoundaryWords);
    at.word("stretchOutline", options.stretchOutline, kStretchOutlineWords);
    at.field("authalic", options.authalic, 0, 1);
};

template <class Fields, class Limits>
void strainLimits(Fields& at, const char* key, Limits& limits) {
    Eigen::Vector2d numbers(limits.least, limits.most);
    at.point(key, numbers);
    if constexpr (Fields::kReads) {
        limits = {numbers[0], numbers[1]};
        if (limits.least > 0 || limits.most < 0 || limits.least <= -1 || limits.most > kMaxStrain) {
            at.fail(key, "must be a number from -1 to 0 and one from 0 to 10");
        }
    }
}

inline constexpr auto kFabric = [](auto& at, auto& fabric) {
    at.field("id", fabric.id);
    strainLimits(at, "warp", fabric.warp);
    strainLimits(at, "weft", fabric.weft);
    strainLimits(at, "bias", fabric.bias);
    at.field("width", fabric.width, 1.0, kMaxClothWidth);
};

inline constexpr auto kMaterial = [](auto& at, auto& material) {
    at.need("name");
    at.field("name", material.name);
    at.object("fabric", material.fabric, kFabric);
};

inline constexpr auto kAnchor = [](auto& at, auto& anchor) {
    at.need("vertex");
    at.need("at");
    at.field("vertex", anchor.vertex, 0, INT_MAX);
    at.point("at", anchor.flat, kFarthestOnSheet);
    at.point("point", anchor.point);
};

inline constexpr auto kPiece = [](auto& at, auto& piece) {
    auto& settings = piece.settings;
    at.id("id", piece.id);
    at.need("name");
    at.field("name", piece.name);
    at.object("placement", settings.placement, [&settings](auto& in, auto& placement) {
        in.need("offset");
        in.point("offset", placement.offset, kFarthestOnSheet);
        in.field("turn", placement.turn, -kMaxTurn, kMaxTurn);
        in.field("mirrored", placement.mirrored);
        in.unlessStated(settings.placedByHand, true);  // not in older files
        in.field("byHand", settings.placedByHand);
    });
    at.field("grain", settings.grain, -kMaxTurn, kMaxTurn);
    at.field("quantity", settings.quantity, 0, kMaxCopies);
    at.field("mirroredPair", settings.mirroredPair);
    if (at.kReads || settings.byHalf) {
        at.field("byHalf", settings.byHalf);
    }
    at.text("material", settings.material);
    at.unlessStated(settings.materialByHand, !settings.material.empty());  // as in older files
    if (at.kReads || settings.materialByHand == settings.material.empty()) {
        at.field("materialByHand", settings.materialByHand);
    }
    at.id("partOf", settings.partOf);
    for (const auto& [name, chosen] :
         {std::pair<const char*, decltype(&settings.hidden)>{"hidden", &settings.hidden},
          {"leftOut", &settings.leftOut}}) {
        if (at.kReads || *chosen) {
            at.field(name, *chosen);
        }
    }
    if (at.kReads || !settings.anchors.empty()) {
        at.list("anchors", settings.anchors, kAnchor);
    }
};

/// A piece with its label.
using LabelOfPiece = std::pair<PieceId, PieceLabel>;

inline constexpr auto kLabel = [](auto& at, auto& label) {
    at.need("id");
    at.id("id", label.first);
    at.text("name", label.second.name);
    if (at.kReads || label.second.colour >= 0) {
        at.field("colour", label.second.colour, 0, kMaxColour);
    }
};

inline constexpr auto kView = [](auto& at, auto& view) {
    at.text("overlay", view.overlay);
    at.field("wireframe", view.wireframe);
    at.field("designerOutline", view.referencePanels);
    if (at.kReads || view.exactOutline) {
        at.field("exactOutline", view.exactOutline);
    }
    const auto layer = [&at](const char* name, auto& shown) {
        if (at.kReads || !shown) {
            at.field(name, shown);
        }
    };
    layer("cuttingLine", view.cuttingLine);
    layer("notches", view.notches);
    layer("internalLines", view.internalLines);
    layer("grain", view.grain);
    layer("labels", view.labels);
};

/// Cuts, joins and ease as in a seams file, and settings of seams.
inline constexpr auto kSeams = [](auto& at, auto& loading) {
    if constexpr (std::decay_t<decltype(at)>::kReads) {
        readSeams(at.fields(), loading.seams, 1, true);
    } else {
        at.field("unit", loading.seams.unit);
        at.json()["cuts"] = cutsJson(loading.seams, true);
        at.json()["joins"] = joinsJson(loading.seams);
        if (!loading.seams.ease.empty()) {  // by names not yet matched with a garment
            at.json()["ease"] = easeJson(loading.seams, 1);
        }
    }
    if (at.kReads || !loading.seamSettings.empty()) {
        at.list("settings", loading.seamSettings, kSeamSettings);
    }
};

/// All fields but the files, which depend on the location of the project.
template <class Fields, class SomeProject>
void describe(Fields& at, SomeProject& project, std::vector<LabelOfPiece>& labels,
              std::vector<MarkerOfMaterial>& markers) {
    at.object("reading", project.loading, kReading);
    at.list("division", project.loading.known, kKnownPiece);
    at.object("seams", project.loading, kSeams);
    at.object("flattening", project.options, kFlattening);
    at.object("lines", project.lines, kLines);
    at.object("fabric", project.fabric, kFabric);
    if (at.kReads || !project.materials.empty()) {
        at.list("materials", project.materials, kMaterial);
    }
    at.list("pieces", project.pieces, kPiece);
    at.list("labels", labels, kLabel);
    if (at.kReads || !markers.empty()) {
        at.list("markers", markers, kMarker);
    }
    at.object("view", project.view, kView);
}

}  // namespace toile::project_fields
