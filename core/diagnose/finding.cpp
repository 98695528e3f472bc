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

constexpr const char* kSewingAdvice = TR("Correct it in the pattern, then prove again");

constexpr FindingWords kWords[] = {
    {"not-flattened", TR("Not flattened"),
     TR("the pattern is missing or out of date for %1 of %2 pieces"), TR("Flatten the garment")},
    {"not-flat", TR("Pieces that could not be flattened"), "", ""},
    {"outline-crosses", TR("Outlines that cross themselves"), "", ""},
    {"flipped-triangles", TR("Flipped triangles"),
     TR("triangles are flipped or have no area in the pattern (%1 of %2)"),
     TR("Choose another method, or cut the piece where it curves most")},
    {"proof-fault", TR("Proofs that did not settle"), "%0", kSewingAdvice},
    {"mirrored", TR("Mirrored pieces"), "%0", kSewingAdvice},
    {"other-fits", TR("Swapped pieces"), "%0", kSewingAdvice},
    {"seam-slips", TR("Seams with unequal sides"), "%0", kSewingAdvice},
    {"length-differs", TR("Seams longer or shorter than the design"), "%0", kSewingAdvice},
    {"not-there", TR("Pieces missing in the pattern"), "%0", kSewingAdvice},
    {"not-needed", TR("Pieces that are not in the garment"), "%0", kSewingAdvice},
    {"far-off", TR("Pattern of another garment or unit"), "%0", kSewingAdvice},
    {"inside-out", TR("Inside out"),
     TR("faces of the garment point inwards (%0), so their pieces come out mirrored"),
     TR("Turn the garment over. If only parts point inwards, make the normals consistent in the "
        "modelling program"),
     "--turn-over"},
    {"strain-beyond-cloth", TR("Strain too high for any fabric"), "%0",
     TR("Add cuts or darts where the piece curves most. If the file is a thick shell or a scan, "
        "convert it to one sheet first"),
     "--auto-cut --max-strain 5"},
    {"many-scraps", TR("Too many tiny pieces"), "%0",
     TR("Set the unit if the garment is too small. Otherwise leave the tiny pieces out, or split "
        "the file by something else. If it is a scan, convert it to one sheet first"),
     ""},
    {"long-cuts", TR("Cuts longer than the outline"), "%0",
     TR("Split the garment at its own seams, or draw the cuts yourself. If the file is a thick "
        "shell or a scan, convert it to one sheet first"),
     ""},
    {"seam-lengths", TR("Seams that do not match"),
     TR("the flat sides of the seam differ by %1 more than the ease (%2 and %3)"),
     TR("Choose a method that keeps seam lengths, or set the ease")},
    {"strain-warp", TR("Strain along the warp"),
     TR("strain along the warp reaches %1, but the fabric%0 allows %2 (exceeded on %3 of the "
        "area)"),
     TR("Turn the grain, choose a fabric with wider limits, or add a dart or a seam there")},
    {"strain-weft", TR("Strain along the weft"),
     TR("strain along the weft reaches %1, but the fabric%0 allows %2 (exceeded on %3 of the "
        "area)"),
     TR("Turn the grain, choose a fabric with wider limits, or add a dart or a seam there")},
    {"strain-bias", TR("Strain on the bias"),
     TR("strain on the bias reaches %1, but the fabric%0 allows %2 (exceeded on %3 of the area)"),
     TR("Turn the grain, choose a fabric with wider limits, or add a dart or a seam there")},
    {"sewn-gap", TR("Far from the design"),
     TR("the sewn pattern is %1 from the design on average, 95 % within %2; this piece is "
        "farthest, %3 on average"),
     TR("Show the overlay Gap to see where. Try another method, a dart or a seam there, then prove "
        "again")},
    {"seam-kink", TR("Kinks at the ends of seams"),
     TR("the outlines that meet at the end of the seam form a corner of %1"),
     TR("Smooth the corner, or keep it if you want one")},
    {"not-symmetric", TR("Pieces that cannot be cut by half"),
     TR("the piece is set to be cut by half, but it has no mirror image, so it is drawn "
        "whole"),
     TR("Make mirrored pieces equal, or cut the piece whole")},
    {"no-facing", TR("Facings that do not fit"),
     TR("no strip of the facing's width fits along its edge, so the facing is left out"),
     TR("Make the facing narrower, or remove it")},
    {"wider-than-cloth", TR("Wider than the cloth"),
     TR("the piece measures %1, but its cloth has room for only %2"),
     TR("Divide the piece by a cut, turn its grain, or use wider cloth")},
    {"pieces-overlap", TR("Overlapping pieces"), TR("the pieces overlap on the sheet"),
     TR("Move them apart, or lay them out again")},
    {"unlikely-size", TR("Unlikely size"), TR("the garment's largest dimension is %1"),
     TR("Set the unit of its file")},
    {"unit-in-doubt", TR("Uncertain unit"),
     TR("the file states no unit, and its size is ambiguous (%0)"),
     TR("Set the unit, or keep it if the size is right")},
    {"up-axis-in-doubt", TR("Uncertain up axis"),
     TR("the file does not state which axis points up (%0)"),
     TR("Set the axis, or keep it if the garment stands upright"), "--up y or --up z"},
    {"grain-missing", TR("Grain not set"),
     TR("no grain is set, so Toile assumes that it runs upwards"),
     TR("Turn the grain arrow, or let Toile choose the grain with the least stretch")},
    {"reference-note", TR("Notes on the reference pattern"), "%0", ""},
    {"message", TR("Messages"), "", ""},
};

/// For a piece with several rims.
constexpr const char* kTube =
    TR("the piece is a tube with %1 openings and must be cut open to lie flat");

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
    if (const std::string help = adviceFor(finding); !help.empty()) {
        text += ". " + help;
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
