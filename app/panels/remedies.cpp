// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/remedies.h"

#include <QCoreApplication>
#include <algorithm>

#include "core/assemble/cut_pieces.h"

namespace toile::app {
namespace {

/// The context of the translations.
class RemedyWords {
    Q_DECLARE_TR_FUNCTIONS(Remedy)
};

/// Whether the file of a piece has a UV map that it has not been divided by.
bool hasOtherIslands(const Finding& finding, const Garment& garment) {
    return std::ranges::any_of(finding.pieces, [&garment](int index) -> bool {
        const Piece& piece = *garment.pieces[static_cast<std::size_t>(index)];
        const SourceFile& file = *garment.files[static_cast<std::size_t>(piece.file)];
        return !file.soup->cornerUvs.empty() && file.split.mode != SplitMode::Uv;
    });
}

bool isOpenedByCuts(const Finding& finding, const Garment& garment) {
    return std::ranges::any_of(finding.pieces, [&garment](int piece) {
        return isOpenable(*garment.pieces[static_cast<std::size_t>(piece)]);
    });
}

/// Tubes that branch, as tops and trousers do, are cut as tailors do rather than the shortest way.
bool mayBeWorn(const Finding& finding, const Garment& garment) {
    constexpr std::size_t kOpenings = 3;
    return std::ranges::any_of(finding.pieces, [&garment](int piece) {
        return loopLengths(*garment.pieces[static_cast<std::size_t>(piece)]).size() >= kOpenings;
    });
}

struct Words {
    Remedy remedy;
    const char *text, *tip;
};

constexpr Words kWords[] = {
    {Remedy::FlattenNow, QT_TRANSLATE_NOOP("Remedy", "Flatten now"),
     QT_TRANSLATE_NOOP("Remedy", "Flatten what is out of date")},
    {Remedy::DivideByUv, QT_TRANSLATE_NOOP("Remedy", "Divide by UV"),
     QT_TRANSLATE_NOOP("Remedy",
                       "Make each island of the file's UV map one piece; undo brings these back")},
    {Remedy::CutOpen, QT_TRANSLATE_NOOP("Remedy", "Cut open"),
     QT_TRANSLATE_NOOP("Remedy",
                       "Cut this piece open along short seams, which are yours to take back")},
    {Remedy::ProposeCuts, QT_TRANSLATE_NOOP("Remedy", "Propose cuts…"),
     QT_TRANSLATE_NOOP("Remedy",
                       "Show where a tailor would cut this piece open, with what each cut does to "
                       "strain")},
    {Remedy::SetUnit, QT_TRANSLATE_NOOP("Remedy", "Set unit…"),
     QT_TRANSLATE_NOOP("Remedy",
                       "Choose the unit of the file's numbers, or type how tall the garment is")},
    {Remedy::SetUpAxis, QT_TRANSLATE_NOOP("Remedy", "Set axis…"),
     QT_TRANSLATE_NOOP("Remedy", "Choose the axis of the file that points up")},
    {Remedy::TurnOver, QT_TRANSLATE_NOOP("Remedy", "Turn inside out"),
     QT_TRANSLATE_NOOP("Remedy", "Turn all faces of the garment over")},
    {Remedy::StateEase, QT_TRANSLATE_NOOP("Remedy", "State ease…"),
     QT_TRANSLATE_NOOP("Remedy", "Type how much longer one side of the seam is meant to be")},
    {Remedy::BestGrain, QT_TRANSLATE_NOOP("Remedy", "Best grain"),
     QT_TRANSLATE_NOOP("Remedy",
                       "Let the grain run up the garment, or at 90 or 45 degrees to that where the "
                       "fabric is strained much less")},
    {Remedy::ShowStrain, QT_TRANSLATE_NOOP("Remedy", "Show strain"),
     QT_TRANSLATE_NOOP("Remedy", "Colour the pieces by strain")},
    {Remedy::PutDart, QT_TRANSLATE_NOOP("Remedy", "Put a dart"),
     QT_TRANSLATE_NOOP("Remedy",
                       "Propose a dart from the nearest edge to the worst place: Enter cuts it, "
                       "Escape throws it away")},
    {Remedy::LayOutAgain, QT_TRANSLATE_NOOP("Remedy", "Lay out again"),
     QT_TRANSLATE_NOOP("Remedy", "Put all pieces in rows side by side")},
};

const Words& wordsOf(Remedy remedy) {
    return *std::ranges::find(kWords, remedy, &Words::remedy);
}

}  // namespace

bool isOfUnpreparedScan(const Finding& finding, const Garment& garment) {
    return std::ranges::any_of(finding.pieces, [&garment](int index) -> bool {
        const Piece& piece = *garment.pieces[static_cast<std::size_t>(index)];
        const FileReading& reading = garment.files[static_cast<std::size_t>(piece.file)]->reading;
        return reading.kind == FileKind::Scan && !reading.isStated;
    });
}

std::vector<Remedy> remediesFor(const Finding& finding, const CutPlan& plan) {
    switch (finding.kind) {
        case FindingKind::NotFlattened:
            return {Remedy::FlattenNow};
        case FindingKind::NotFlat: {
            std::vector<Remedy> remedies;
            if (isOfUnpreparedScan(finding, *plan.garment)) {
                return remedies;  // the question above the views has the button
            }
            if (hasOtherIslands(finding, *plan.garment)) {
                remedies.push_back(Remedy::DivideByUv);
            }
            if (isOpenedByCuts(finding, *plan.garment)) {
                if (mayBeWorn(finding, *plan.garment)) {
                    remedies.push_back(Remedy::ProposeCuts);
                }
                remedies.push_back(Remedy::CutOpen);
            }
            return remedies;
        }
        case FindingKind::StrainBeyondCloth:
            return isOfUnpreparedScan(finding, *plan.garment)
                       ? std::vector{Remedy::ShowStrain}
                       : std::vector{Remedy::ProposeCuts, Remedy::ShowStrain};
        case FindingKind::SeamLengths:
            return {Remedy::StateEase};
        case FindingKind::StrainWarp:
        case FindingKind::StrainWeft:
        case FindingKind::StrainBias:
            return {Remedy::PutDart, Remedy::BestGrain};
        case FindingKind::PiecesOverlap:
            return {Remedy::LayOutAgain};
        case FindingKind::UnlikelySize:
        case FindingKind::UnitInDoubt:
            return {Remedy::SetUnit};
        case FindingKind::UpAxisInDoubt:
            return {Remedy::SetUpAxis};
        case FindingKind::InsideOut:
            return {Remedy::TurnOver};
        case FindingKind::GrainMissing:
            return {Remedy::BestGrain};
        default:
            return {};
    }
}

QString remedyText(Remedy remedy) {
    return RemedyWords::tr(wordsOf(remedy).text);
}

QString remedyTip(Remedy remedy) {
    return RemedyWords::tr(wordsOf(remedy).tip);
}

std::vector<ActionId> actionsOf(Remedy remedy) {
    switch (remedy) {
        case Remedy::FlattenNow:
            return {ActionId::FlattenAgain};
        case Remedy::DivideByUv:
            return {ActionId::SplitUv};
        case Remedy::CutOpen:
            return {ActionId::CutOpen};
        case Remedy::ProposeCuts:
            return {ActionId::ProposeCuts};
        case Remedy::SetUnit:
            return {ActionId::UnitMillimetre, ActionId::UnitCentimetre, ActionId::UnitDecimetre,
                    ActionId::UnitMetre, ActionId::UnitInch};
        case Remedy::SetUpAxis:
            return {ActionId::UpY, ActionId::UpZ};
        case Remedy::TurnOver:
            return {ActionId::TurnOver};
        case Remedy::StateEase:
            return {ActionId::StateEase};
        case Remedy::BestGrain:
            return {ActionId::BestGrain};
        case Remedy::ShowStrain:
            return {ActionId::OverlayStrain};
        case Remedy::PutDart:
            return {ActionId::ToolDart};
        case Remedy::LayOutAgain:
            return {ActionId::LayOutAgain};
    }
    return {};
}

}  // namespace toile::app
