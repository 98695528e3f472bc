// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/diagnose/finding.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
#include <numbers>

#include "core/base/characters.h"
#include "core/base/setting.h"
#include "core/base/text.h"
#include "core/base/wording.h"

namespace toile {
namespace {

constexpr Word<Severity> kSeverities[] = {
    {Severity::Fault, "fault"}, {Severity::Doubt, "doubt"}, {Severity::Note, "note"}};

constexpr const char* kSewingAdvice =
    TR("Look at it in the pattern, put it right, and prove again");

constexpr FindingWords kWords[] = {
    {"not-flattened", TR("Not flattened"),
     TR("the pattern does not show the garment as it is now (%1 of %2 pieces)"), TR("Flatten it")},
    {"not-flat", TR("Pieces that are not flat"), "", ""},
    {"outline-crosses", TR("Outlines that cross themselves"), "", ""},
    {"flipped-triangles", TR("Flipped cloth"),
     TR("triangles are flipped or without area in the pattern (%1 of %2)"),
     TR("Choose another method, or cut the piece where it curves most")},
    {"proof-fault", TR("Cloth that did not come to rest"), "%0", kSewingAdvice},
    {"mirrored", TR("Pieces that are mirrored"), "%0", kSewingAdvice},
    {"other-fits", TR("Pieces that fit another place"), "%0", kSewingAdvice},
    {"seam-slips", TR("Seams that slip"), "%0", kSewingAdvice},
    {"length-differs", TR("Seams of another length than the design"), "%0", kSewingAdvice},
    {"not-there", TR("Pieces that the pattern lacks"), "%0", kSewingAdvice},
    {"not-needed", TR("Pieces that the garment lacks"), "%0", kSewingAdvice},
    {"far-off", TR("Cloth nowhere near the design"), "%0", kSewingAdvice},
    {"inside-out", TR("Inside out"),
     TR("faces of the garment look inwards (%0): their pieces come out mirrored, wrong "
        "side up"),
     TR("Turn the garment; if only parts of it look inwards, make the normals consistent "
        "in the modelling program"),
     "--turn-over"},
    {"strain-beyond-cloth", TR("Strain beyond any cloth"), "%0",
     TR("Cut the piece open or put darts where it curves most; if the file is a thick "
        "shell or a scan, make one sheet of it first"),
     "--auto-cut --enough 5"},
    {"many-scraps", TR("Scraps instead of pieces"), "%0",
     TR("State the unit if the garment is too small; else leave the scraps out, or divide "
        "the file by something else; if it is a scan, make one sheet of it first"),
     ""},
    {"long-cuts", TR("Cuts longer than the outline"), "%0",
     TR("Divide the garment by its own seams, or draw the cuts where seams are to be; "
        "if the file is a thick shell or a scan, make one sheet of it first"),
     ""},
    {"seam-lengths", TR("Seams that do not match"),
     TR("the flat sides of the seam differ by %1 beyond the ease (%2 and %3)"),
     TR("Choose a method that keeps seam lengths, or state the ease that is meant")},
    {"strain-warp", TR("Strain along the warp"),
     TR("strain along the warp reaches %1, the fabric%0 takes %2 (%3 of the area lies beyond)"),
     TR("Turn the grain, choose a fabric that gives more, or open a dart or a seam there")},
    {"strain-weft", TR("Strain along the weft"),
     TR("strain along the weft reaches %1, the fabric%0 takes %2 (%3 of the area lies beyond)"),
     TR("Turn the grain, choose a fabric that gives more, or open a dart or a seam there")},
    {"strain-bias", TR("Strain on the bias"),
     TR("strain on the bias reaches %1, the fabric%0 takes %2 (%3 of the area lies beyond)"),
     TR("Turn the grain, choose a fabric that gives more, or open a dart or a seam there")},
    {"sewn-gap", TR("Far from the design"),
     TR("sewn back, the pattern sits %1 from the design on average, %2 at the worst twentieth; "
        "this piece is the farthest off, %3 on average"),
     TR("Look where it is with the overlay Gap; try another method, a dart or a seam there, and "
        "prove again")},
    {"seam-kink", TR("Kinks at the ends of seams"),
     TR("the lines that meet over the end of the seam make a corner of %1"),
     TR("True the seam's end, or leave it if a corner is meant")},
    {"not-symmetric", TR("Pieces that have no half"),
     TR("the piece is to be cut by half, but is not drawn as a mirror image: it is drawn whole"),
     TR("Draw pieces that mirror each other alike, or cut it whole")},
    {"no-facing", TR("Facings without room"),
     TR("no strip of the facing's width can be copied along its edge: it is left out"),
     TR("Make the facing narrower, or take it away")},
    {"wider-than-cloth", TR("Wider than the cloth"),
     TR("it measures %1 where its cloth has room for %2"),
     TR("Cut it apart, turn its grain, or take wider cloth")},
    {"pieces-overlap", TR("Pieces on each other"), TR("the pieces lie on each other on the sheet"),
     TR("Move them apart, or lay them out again")},
    {"unlikely-size", TR("Unlikely size"), TR("the garment is %1 at its largest"),
     TR("State the unit of its file")},
    {"unit-in-doubt", TR("Unit in doubt"),
     TR("the file states no unit, and its size leaves doubt (%0)"),
     TR("State the unit, or keep it if the size is right")},
    {"up-axis-in-doubt", TR("Up axis in doubt"),
     TR("the file does not say which axis points up (%0)"),
     TR("State the axis, or keep it if the garment stands upright"), "--up y or --up z"},
    {"grain-missing", TR("Grain not set"), TR("no grain is set: it is taken to run upwards"),
     TR("Turn the grain arrow, or let Toile find the best grain")},
    {"reference-note", TR("Notes on the reference pattern"), "%0", ""},
    {"message", TR("Messages"), "", ""},
};

/// For a piece with several rims.
constexpr const char* kTube =
    TR("the piece is a tube with %1 openings, and lies flat only when it is cut open");

static_assert(std::size(kWords) == kFindingKindCount);

std::string written(const Figure& figure) {
    constexpr double kInPercent = 100, kFine = 100, kDegrees = 180 / std::numbers::pi;
    switch (figure.unit) {
        case Figure::Unit::Length:
            return fixed(figure.value, std::abs(figure.value) < kFine ? 2 : 1) + " mm";
        case Figure::Unit::Percent:
            return fixed(kInPercent * figure.value, 1) + " %";
        case Figure::Unit::Strain: {
            const std::string number = fixed(kInPercent * figure.value, 1);
            return (number.front() == '-' ? "" : "+") + number + " %";
        }
        case Figure::Unit::Angle:
            return fixed(figure.value * kDegrees, 1) + "°";
        case Figure::Unit::Count:
            return fixed(figure.value, 0);
    }
    return {};
}

}  // namespace

const FindingWords& findingWords(FindingKind kind) {
    return kWords[static_cast<std::size_t>(kind)];
}

const char* patternOf(const Finding& finding) {
    if (!finding.error) {
        return findingWords(finding.kind).describe;
    }
    const bool isTube = finding.error->code == ErrorCode::SeveralLoops && !finding.figures.empty();
    return isTube ? kTube : "";
}

std::string description(const Finding& finding) {
    const char* pattern = patternOf(finding);
    if (*pattern == '\0' && finding.error) {
        std::string text(describe(finding.error->code));
        return finding.error->detail.empty()
                   ? text
                   : text + " (" + shownText(finding.error->detail, kMaxOfDetail) + ")";
    }
    std::string text;
    for (const char* at = pattern; *at != '\0'; ++at) {
        const bool isPlace = *at == '%' && std::isdigit(static_cast<unsigned char>(at[1])) != 0;
        if (!isPlace) {
            text += *at;
            continue;
        }
        const auto number = static_cast<std::size_t>(*++at - '0');
        if (number == 0) {
            text += finding.reason;
        } else if (number <= finding.figures.size()) {
            text += written(finding.figures[number - 1]);
        }
    }
    return text;
}

std::string adviceFor(const Finding& finding) {
    return finding.error ? std::string(advice(finding.error->code))
                         : findingWords(finding.kind).advice;
}

std::string sentence(const Finding& finding) {
    // `reason` of these kinds is a full sentence that contains the names.
    const bool isFoundBySewing =
        FindingKind::ProofFault <= finding.kind && finding.kind <= FindingKind::FarOff;
    const bool isNamed = finding.subject.name.empty() || isFoundBySewing;
    std::string text = isNamed ? "" : shownText(finding.subject.name, kMaxOfPlace) + ": ";
    text += description(finding);
    std::string help = adviceFor(finding);
    if (!help.empty()) {
        help.front() = lowered(help.front());
        text += "; " + help;
    }
    const std::string_view option =
        finding.error ? commandLineOption(finding.error->code) : findingWords(finding.kind).option;
    if (!option.empty()) {
        text += " (" + std::string(option) + ")";
    }
    return text + ".";
}

FindingPlace placeInTriangle(const Piece& piece, const Points2& Q, Eigen::Index face) {
    FindingPlace place;
    for (int k = 0; k < 3; ++k) {
        place.flat += Q.row(piece.mesh.F(face, k)).transpose() / 3;
        place.position += piece.mesh.V.row(piece.mesh.F(face, k)).transpose() / 3;
    }
    const Eigen::Vector3d normal = doubleAreaNormal(piece.mesh, face);
    const double length = normal.norm();
    place.normal = length > 0 ? Eigen::Vector3d(normal / length) : Eigen::Vector3d::Zero();
    return place;
}

std::string_view name(Severity severity) {
    return wordOf(kSeverities, severity);
}

std::string_view name(FindingKind kind) {
    return findingWords(kind).name;
}

}  // namespace toile
