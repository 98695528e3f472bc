// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/remedies.h"

#include <QCoreApplication>
#include <algorithm>

#include "core/assemble/cut_pieces.h"

namespace toile::app {
namespace {

/// Translation context.
class RemedyWords {
    Q_DECLARE_TR_FUNCTIONS(Remedy)
};

/// True if the file of a piece has a UV map that does not divide it.
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

/// Branching tubes, such as tops and trousers, get tailors' cuts rather than the shortest ones.
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
     QT_TRANSLATE_NOOP("Remedy", "Flatten the pieces that are out of date")},
    {Remedy::DivideByUv, QT_TRANSLATE_NOOP("Remedy", "Split by UV"),
     QT_TRANSLATE_NOOP("Remedy", "Make each UV island of the file one piece; you can undo this")},
    {Remedy::CutOpen, QT_TRANSLATE_NOOP("Remedy", "Cut open"),
     QT_TRANSLATE_NOOP("Remedy", "Cut this piece open along short seams; you can undo this")},
    {Remedy::ProposeCuts, QT_TRANSLATE_NOOP("Remedy", "Propose cuts…"),
     QT_TRANSLATE_NOOP("Remedy",
                       "Show where a tailor would cut this piece, and the effect on strain")},
    {Remedy::SetUnit, QT_TRANSLATE_NOOP("Remedy", "Set unit…"),
     QT_TRANSLATE_NOOP("Remedy", "Choose the unit of the file, or enter the garment's height")},
    {Remedy::SetUpAxis, QT_TRANSLATE_NOOP("Remedy", "Set axis…"),
     QT_TRANSLATE_NOOP("Remedy", "Choose the axis of the file that points up")},
    {Remedy::TurnOver, QT_TRANSLATE_NOOP("Remedy", "Turn inside out"),
     QT_TRANSLATE_NOOP("Remedy", "Flip all faces of the garment")},
    {Remedy::StateEase, QT_TRANSLATE_NOOP("Remedy", "Set ease…"),
     QT_TRANSLATE_NOOP("Remedy", "Set how much longer one side of the seam is")},
    {Remedy::BestGrain, QT_TRANSLATE_NOOP("Remedy", "Best grain"),
     QT_TRANSLATE_NOOP("Remedy",
                       "Run the grain upwards, or turn it 45° or 90° if that strains much less")},
    {Remedy::ShowStrain, QT_TRANSLATE_NOOP("Remedy", "Show strain"),
     QT_TRANSLATE_NOOP("Remedy", "Colour the pieces by strain")},
    {Remedy::PutDart, QT_TRANSLATE_NOOP("Remedy", "Add dart"),
     QT_TRANSLATE_NOOP("Remedy",
                       "Propose a dart to the worst place: Enter cuts it, Esc discards it")},
    {Remedy::LayOutAgain, QT_TRANSLATE_NOOP("Remedy", "Lay out again"),
     QT_TRANSLATE_NOOP("Remedy", "Arrange all pieces in rows")},
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
                return remedies;  // the banner above the views has the button
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
            return {overlayAction(Overlay::Strain)};
        case Remedy::PutDart:
            return {ActionId::ToolDart};
        case Remedy::LayOutAgain:
            return {ActionId::LayOutAgain};
    }
    return {};
}

}  // namespace toile::app
