// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/check/finding.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
#include <numbers>

#include "core/base/characters.h"
#include "core/base/text.h"
#include "core/base/version.h"
#include "core/base/wording.h"
#include "core/check/ready_to_cut.h"
#include "core/diagnose/doubt.h"
#include "core/formats/json.h"

namespace toile {
namespace {

// The window's translation tools look for this name (app/translations.cmake).
#define TR(text) text

constexpr Word<Severity> kSeverities[] = {
    {Severity::Fault, "fault"}, {Severity::Doubt, "doubt"}, {Severity::Note, "note"}};

constexpr FindingWords doubtRow(DoubtKind kind) {
    const DoubtWords& words = kDoubtWords[static_cast<std::size_t>(kind)];
    return {words.name, words.title, words.describe, words.advice};
}

constexpr FindingWords kWords[] = {
    {"not-flattened", TR("Not flattened"),
     TR("the pattern does not show the garment as it is now (%1 of %2 pieces)"), TR("Flatten it")},
    {"not-flat", TR("Pieces that are not flat"), "", ""},
    {"outline-crosses", TR("Outlines that cross themselves"), "", ""},
    {"flipped-triangles", TR("Flipped cloth"),
     TR("triangles are flipped or without area in the pattern (%1 of %2)"),
     TR("Choose another method, or cut the piece where it curves most")},
    {"proof-fault", TR("Faults found by sewing"), "%0",
     TR("Look at it in the pattern, put it right, and prove again")},
    doubtRow(DoubtKind::InsideOut),
    doubtRow(DoubtKind::StrainBeyondCloth),
    doubtRow(DoubtKind::ManyScraps),
    doubtRow(DoubtKind::LongCuts),
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
    doubtRow(DoubtKind::UpAxisInDoubt),
    {"grain-missing", TR("Grain not set"), TR("no grain is set: it is taken to run upwards"),
     TR("Turn the grain arrow, or let Toile find the best grain")},
    {"reference-note", TR("Notes on the reference pattern"), "%0", ""},
    {"message", TR("Messages"), "", ""},
};

/// For a piece with several rims.
constexpr const char* kTube =
    TR("the piece is a tube with %1 openings, and lies flat only when it is cut open");

#undef TR

static_assert(std::size(kWords) == kFindingKindCount);

std::string written(const Figure& figure) {
    constexpr double kPercent = 100, kFine = 100, kDegrees = 180 / std::numbers::pi;
    switch (figure.unit) {
        case Figure::Unit::Length:
            return fixed(figure.value, std::abs(figure.value) < kFine ? 2 : 1) + " mm";
        case Figure::Unit::Percent:
            return fixed(kPercent * figure.value, 1) + " %";
        case Figure::Unit::Strain: {
            const std::string number = fixed(kPercent * figure.value, 1);
            return (number.front() == '-' ? "" : "+") + number + " %";
        }
        case Figure::Unit::Angle:
            return fixed(figure.value * kDegrees, 1) + "°";
        case Figure::Unit::Count:
            return fixed(figure.value, 0);
    }
    return {};
}

/// The command line option that answers a doubt.
std::string_view optionOf(FindingKind kind) {
    const std::string_view wanted = findingWords(kind).name;
    const auto* const found = std::ranges::find(kDoubtWords, wanted, &DoubtWords::name);
    return found == std::end(kDoubtWords) ? std::string_view() : found->option;
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
    // The text of a proof fault is a full sentence that contains the names.
    const bool isNamed = finding.subject.name.empty() || finding.kind == FindingKind::ProofFault;
    std::string text = isNamed ? "" : readableName(finding.subject.name) + ": ";
    text += description(finding);
    std::string help = adviceFor(finding);
    if (!help.empty()) {
        help.front() = lowered(help.front());
        text += "; " + help;
    }
    const auto option =
        finding.error ? commandLineOption(finding.error->code) : optionOf(finding.kind);
    if (!option.empty()) {
        text += " (" + std::string(option) + ")";
    }
    return text + ".";
}

std::string_view name(Severity severity) {
    return wordOf(kSeverities, severity);
}

std::string_view name(FindingKind kind) {
    return findingWords(kind).name;
}

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
