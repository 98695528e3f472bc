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
#include "core/marker/marker_fields.h"
#include "core/pattern/line_fields.h"
#include "core/prepare/scan_fields.h"
#include "core/project/piece_settings.h"
#include "core/project/project.h"
#include "core/prove/proof_fields.h"

namespace toile::project_fields {

/// Fields of a project file, one function per type; included in one file.

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
    at.text("material", marker.first);
    kMarkerSettingsFields(at, marker.second.settings);
    if (at.kReads || !marker.second.kept.empty()) {
        at.list("kept", marker.second.kept, kKeptCopy);
    }
};

inline constexpr double kMaxStrain = 10;
inline constexpr int kMaxColour = 1000000;
inline constexpr double kMaxTurn = 1e6;  ///< radians: beyond, the sine of a double is no direction

inline constexpr auto kPreparation = [](auto& at, auto& preparation) {
    at.word("as", preparation.as, kFileKindWords);
    at.word("surface", preparation.surface, kShellSurfaceWords);
    at.object("scan", preparation.scan, kScanStepFields);
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

inline constexpr auto kSeamPart = [](auto& at, auto& part) {
    at.field("from", part.from, 0, 1);
    at.field("to", part.to, 0, 1);
    if (!(part.from < part.to)) {
        at.fail("to", "must be more than \"from\"");
    }
};

inline constexpr auto kSeamSettings = [](auto& at, auto& chosen) {
    at.need("left");
    at.object("left", chosen.place.left, kStretchFields);
    if (at.kReads || chosen.place.right.line) {
        at.object("right", chosen.place.right, kStretchFields);
    }
    at.field("ease", chosen.ease, -1, kMaxEase);
    if (chosen.ease && *chosen.ease <= -1) {
        at.fail("ease", "must be more than -1");
    }
    at.object("drawn", chosen.drawn, kSeamPart);
    at.text("name", chosen.name);
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
    at.object("lines", project.lines, kLineFields);
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
