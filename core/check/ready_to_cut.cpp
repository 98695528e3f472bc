// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/check/ready_to_cut.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include <Eigen/Geometry>

#include "core/assemble/identify.h"
#include "core/base/file.h"
#include "core/base/text.h"
#include "core/base/wording.h"
#include "core/check/piece_check.h"
#include "core/diagnose/doubt.h"
#include "core/layout/arrange.h"
#include "core/layout/free_place.h"
#include "core/pattern/half_pattern.h"
#include "core/pattern/trueing.h"
#include "core/project/piece_names.h"
#include "core/project/place_pieces.h"
#include "core/prove/proof.h"
#include "core/seam/seam_measure.h"

namespace toile {
namespace {

constexpr Word<Verdict> kVerdicts[] = {{Verdict::NotFlattened, "not-flattened"},
                                       {Verdict::Faults, "faults"},
                                       {Verdict::Doubts, "doubts"},
                                       {Verdict::Ready, "ready"}};

}  // namespace

int Readiness::count(Severity severity) const {
    return static_cast<int>(std::ranges::count(findings, severity, &Finding::severity));
}

Verdict Readiness::verdict() const {
    const bool isFlattened = std::ranges::none_of(findings, [](const Finding& finding) -> bool {
        return finding.kind == FindingKind::NotFlattened;
    });
    return !isFlattened                 ? Verdict::NotFlattened
           : count(Severity::Fault) > 0 ? Verdict::Faults
           : count(Severity::Doubt) > 0 ? Verdict::Doubts
                                        : Verdict::Ready;
}

std::string_view name(Verdict verdict) {
    return wordOf(kVerdicts, verdict);
}

std::string verdictText(const Readiness& readiness) {
    const int faults = readiness.count(Severity::Fault), doubts = readiness.count(Severity::Doubt);
    switch (readiness.verdict()) {
        case Verdict::NotFlattened:
            return "Not flattened yet";
        case Verdict::Faults:
            return counted(faults, "fault") + (doubts > 0 ? ", " + counted(doubts, "doubt") : "");
        case Verdict::Doubts:
            return "No faults, " + counted(doubts, "doubt");
        case Verdict::Ready:
            break;
    }
    return "Ready to cut";
}

void FindingList::add(const Error& error, std::vector<int> pieces) {
    Finding finding;
    finding.severity = isNote(error.code) ? Severity::Note : Severity::Fault;
    finding.subject = error.subject;
    finding.pieces = std::move(pieces);
    finding.error = error;
    add(std::move(finding));
}

Readiness FindingList::inOrder() {
    std::ranges::stable_sort(found_, {}, [](const Finding& finding) {
        return std::tuple(finding.severity, finding.kind, -finding.badness);
    });
    Readiness readiness;
    readiness.findings = std::exchange(found_, {});
    return readiness;
}

namespace {

/// The piece's flat result; null if it has none or one of another shape.
const PieceResult* flatResult(const CutPlan& plan, int piece) {
    const auto i = static_cast<std::size_t>(piece);
    const PieceResult* result =
        piece >= 0 && i < plan.results.size() ? plan.results[i].get() : nullptr;
    return result && result->flat && result->piece == plan.garment->pieces[i] ? result : nullptr;
}

/// Whether another finding already reports it.
bool isReportedElsewhere(const CutPlan& plan, const Finding& fault) {
    if (fault.kind == FindingKind::NotThere) {
        return std::ranges::none_of(fault.pieces, [&](int piece) {
            const PieceResult* result = flatResult(plan, piece);
            return result && !(result->quality && result->quality->outlineCrossings > 0);
        });
    }
    const auto& seams = plan.garment->seams.seams;
    const auto seam = static_cast<std::size_t>(fault.seam);
    if (fault.kind != FindingKind::SeamSlips || fault.seam < 0 || seam >= seams.size() ||
        !flatResult(plan, seams[seam].left.piece) || !flatResult(plan, seams[seam].right.piece)) {
        return false;
    }
    const SeamFit fit = seamFit(seams[seam], measured(*plan.garment, plan.results, fault.seam));
    return fit == SeamFit::Nearly || fit == SeamFit::Differs;
}

void checkFaults(const CutPlan& plan, FindingList& found) {
    for (const Finding& fault : plan.proof->faults) {
        if (isReportedElsewhere(plan, fault)) {
            continue;
        }
        found.add(fault);
    }
}

/// A gap measured before the cloth came to rest may be far too small.
void checkRest(FindingList& found) {
    Finding finding;
    finding.kind = FindingKind::ProofFault;
    finding.severity = Severity::Doubt;
    finding.reason = worded("the simulation has not settled, so its gap is not reliable");
    found.add(std::move(finding));
}

void checkGap(const CutPlan& plan, FindingList& found) {
    const Proof& proof = *plan.proof;
    if (!proof.hasSettled) {
        checkRest(found);
        return;
    }
    if (!(proof.gap.mean >= kDoubtfulGap)) {
        return;
    }
    const auto meanOf = [](const ProvenPiece& piece) {
        return piece.isSewn() ? piece.gapFigures.mean : -1;
    };
    const auto farthest = std::ranges::max_element(proof.pieces, {}, meanOf);
    const auto index = static_cast<std::size_t>(farthest - proof.pieces.begin());
    const Piece& piece = *plan.garment->pieces[index];
    Finding finding;
    finding.kind = FindingKind::SewnGap;
    finding.severity = Severity::Doubt;
    finding.subject = subjectOf(piece);
    finding.pieces = {static_cast<int>(index)};
    finding.figures = {{proof.gap.mean, Figure::Unit::Length},
                       {proof.gap.most95, Figure::Unit::Length},
                       {farthest->gapFigures.mean, Figure::Unit::Length}};
    const int vertex = farthest->gapFigures.place;
    const PieceResult* result = flatResult(plan, static_cast<int>(index));
    if (result && vertex >= 0 && vertex < piece.mesh.V.rows()) {
        finding.place = placeAtVertex(piece, result->flat->Q, vertex);
    }
    finding.badness = proof.gap.mean;
    found.add(std::move(finding));
}

/// Adds the findings of the proof (the pattern sewn back together): a doubtful mean gap, and faults
/// found before sewing. A seam that slips is reported once, by its lengths (`SeamLengths`). A piece
/// that is not flat, or crosses itself, has its own finding. Adds nothing if the plan has no proof,
/// or one with another number of pieces. Precondition: there is a garment. Cost: that of measuring
/// the seams that slip. Pure.
void checkProof(const CutPlan& plan, FindingList& found) {
    if (plan.proof && !plan.proof->pieces.empty() &&
        plan.proof->pieces.size() == plan.garment->pieces.size()) {
        checkFaults(plan, found);
        checkGap(plan, found);
    }
}

Figure length(double millimetres) {
    return {millimetres, Figure::Unit::Length};
}

class Checks {
public:
    Checks(const CutPlan& plan, const Progress& progress)
        : plan_(plan), garment_(*plan.garment), progress_(progress) {}

    Readiness run() {
        checkFiles();
        checkSize();
        checkPresence();
        for (std::size_t i = 0; i < garment_.pieces.size() && !progress_.isCancelled(); ++i) {
            const int piece = static_cast<int>(i);
            if (const PieceResult* result = resultOf(piece)) {
                const PieceSettings settings = settingsOf(piece);
                checkPiece({piece, *result, settings,
                            fabricOf(settings.material, plan_.materials, plan_.fabric)},
                           found_);
            }
        }
        if (!progress_.isCancelled()) {
            checkDoubts();
            checkSeams();
            checkSeamEnds();
            checkHalves();
            checkFacings();
            checkSheet();
            checkProof(plan_, found_);
        }
        std::vector<ClothNeed> needs;
        if (!progress_.isCancelled()) {
            needs = checkCloth();
        }
        Readiness readiness = found_.inOrder();
        readiness.cloth = std::move(needs);
        for (Finding& finding : readiness.findings) {
            finding.subject = labelled(plan_.labels, std::move(finding.subject));
        }
        return readiness;
    }

private:
    /// The piece's result, of any options; null if it is of another shape.
    const PieceResult* resultOf(int piece) const {
        const auto i = static_cast<std::size_t>(piece);
        const PieceResult* result = i < plan_.results.size() ? plan_.results[i].get() : nullptr;
        return result && result->piece == garment_.pieces[i] ? result : nullptr;
    }

    PieceSettings settingsOf(int piece) const {
        const auto i = static_cast<std::size_t>(piece);
        return i < plan_.settings.size() ? plan_.settings[i] : PieceSettings{};
    }

    void checkFiles() {
        const std::vector<FileId> ids = fileIds(garment_.files);
        for (std::size_t f = 0; f < ids.size(); ++f) {
            const auto& file = garment_.files[f];
            Finding finding;
            finding.severity = Severity::Doubt;
            finding.subject = Subject::file(pathText(file->path.filename()), ids[f]);
            if (file->unitInDoubt && !plan_.guessesKept) {
                finding.kind = FindingKind::UnitInDoubt;
                finding.reason = file->unitReason;
                found_.add(finding);
            }
            for (const Error& problem : file->problems) {
                if (problem.code != ErrorCode::UnitGuessed) {  // reported above
                    found_.add(problem, piecesOf(problem.subject));
                }
            }
        }
        for (const Error& problem : garment_.problems) {
            found_.add(problem, piecesOf(problem.subject));
        }
        for (const Wording& note : plan_.referenceNotes) {
            found_.add(Finding{.kind = FindingKind::ReferenceNote,
                               .subject = Subject::file(plan_.referenceName),
                               .reason = note});
        }
    }

    /// The piece itself, or its parts after it was joined or cut.
    std::vector<int> piecesOf(const Subject& subject) const {
        std::vector<int> pieces;
        const PieceId id = subject.pieceId();
        for (std::size_t i = 0; id && i < garment_.pieces.size(); ++i) {
            const Piece& piece = *garment_.pieces[i];
            if (piece.id == id ||
                std::binary_search(piece.lineage.uncut.begin(), piece.lineage.uncut.end(), id)) {
                pieces.push_back(static_cast<int>(i));
            }
        }
        return pieces;
    }

    void checkSize() {
        Eigen::AlignedBox3d box;
        for (const auto& piece : garment_.pieces) {
            if (piece->mesh.V.rows() > 0) {
                box.extend(Eigen::Vector3d(piece->mesh.V.colwise().minCoeff().transpose()));
                box.extend(Eigen::Vector3d(piece->mesh.V.colwise().maxCoeff().transpose()));
            }
        }
        const double extent = box.isEmpty() ? 0 : box.sizes().maxCoeff();
        if (!box.isEmpty() && !(extent >= kSmallestGarment && extent <= kLargestGarment)) {
            Finding finding;
            finding.kind = FindingKind::UnlikelySize;
            finding.severity = Severity::Doubt;
            finding.figures = {length(extent)};
            found_.add(std::move(finding));
        }
    }

    /// Checks that there are results, and that they are of the present options.
    void checkPresence() {
        int missing = 0;
        for (std::size_t i = 0; i < garment_.pieces.size(); ++i) {
            const PieceResult* result = resultOf(static_cast<int>(i));
            const bool isThere = result && result->options == plan_.options &&
                                 !(result->error && result->error->code == ErrorCode::Cancelled);
            missing += isThere ? 0 : 1;
        }
        if (missing > 0) {
            Finding finding;
            finding.kind = FindingKind::NotFlattened;
            finding.severity = Severity::Fault;
            finding.figures = {count(missing), count(static_cast<double>(garment_.pieces.size()))};
            found_.add(std::move(finding));
        }
    }

    void checkDoubts() {
        std::vector<Fabric> fabrics;
        for (std::size_t i = 0; i < garment_.pieces.size(); ++i) {
            fabrics.push_back(
                fabricOf(settingsOf(static_cast<int>(i)).material, plan_.materials, plan_.fabric));
        }
        for (Finding& doubt : findDoubts(garment_, plan_.results, fabrics)) {
            if (doubt.kind == FindingKind::UpAxisInDoubt && plan_.guessesKept) {
                continue;
            }
            doubt.pieces = piecesOf(doubt.subject);
            found_.add(std::move(doubt));
        }
    }

    void checkSeams() {
        const auto& seams = garment_.seams.seams;
        for (std::size_t i = 0; i < seams.size(); ++i) {
            const Seam& seam = seams[i];
            if (seam.kind == SeamKind::Free || !resultOf(seam.left.piece) ||
                !resultOf(seam.right.piece)) {
                continue;
            }
            const auto measure = measured(garment_, plan_.results, static_cast<int>(i));
            const SeamFit fit = seamFit(seam, measure);
            if (fit != SeamFit::Nearly && fit != SeamFit::Differs) {
                continue;
            }
            Finding finding;
            finding.kind = FindingKind::SeamLengths;
            finding.severity = fit == SeamFit::Differs ? Severity::Fault : Severity::Doubt;
            finding.subject = Subject::seam(nameOf(plan_.labels, garment_, seam), seam.id);
            finding.pieces = {seam.left.piece};
            if (seam.right.piece != seam.left.piece) {
                finding.pieces.push_back(seam.right.piece);
            }
            finding.seam = static_cast<int>(i);
            const double error = std::abs(measure->errorMm);
            finding.figures = {length(error), length(measure->length2dLeft),
                               length(measure->length2dRight)};
            finding.badness = error;
            found_.add(std::move(finding));
        }
    }

    void checkSeamEnds() {
        const auto segments =
            findSegments(garment_, exactResults(garment_, plan_.results), plan_.lines);
        for (const SeamEnd& end : findSeamEnds(garment_, segments, plan_.lines)) {
            const bool isDrawn = end.isTrued && resultOf(end.left.piece)->flat->line &&
                                 resultOf(end.right.piece)->flat->line;
            if (isDrawn || std::abs(end.kink) < kTellingKink) {
                continue;
            }
            const Seam& seam = garment_.seams.seams[static_cast<std::size_t>(end.seam)];
            Finding finding;
            finding.kind = FindingKind::SeamKink;
            finding.subject = Subject::seam(nameOf(plan_.labels, garment_, seam), seam.id);
            finding.pieces = {end.left.piece};
            if (end.right.piece != end.left.piece) {
                finding.pieces.push_back(end.right.piece);
            }
            finding.seam = end.seam;
            finding.place = placeOf(end.left, segments);
            finding.figures = {{std::abs(end.kink), Figure::Unit::Angle}};
            finding.badness = std::abs(end.kink);
            found_.add(std::move(finding));
        }
    }

    FindingPlace placeOf(const OutlineCorner& corner,
                         const std::vector<OutlineSegments>& segments) const {
        const PieceResult& result = *resultOf(corner.piece);
        const Piece& piece = *result.piece;
        const auto& of = segments[static_cast<std::size_t>(corner.piece)];
        const Segment& after = of.segments[static_cast<std::size_t>(corner.point)];
        const int vertex = piece.boundary[static_cast<std::size_t>(after.at.first)];
        return {result.flat->Q.row(vertex), piece.mesh.V.row(vertex)};
    }

    void checkHalves() {
        std::vector<DrawnMirror> mirrors = drawnMirrors(plan_.results);
        mirrors.resize(garment_.pieces.size());  // a window may have results of some pieces only
        if (isOfGarment(plan_.pattern.get())) {  // it also considers the cutting lines
            std::ranges::transform(plan_.pattern->pieces, mirrors.begin(), &PatternPiece::mirror);
        }
        for (std::size_t i = 0; i < garment_.pieces.size(); ++i) {
            const PieceResult* result = resultOf(static_cast<int>(i));
            const bool byHalf = settingsOf(static_cast<int>(i)).byHalf;
            if (!byHalf || !result || !result->flat || cutAs(mirrors[i], byHalf) != CutAs::Whole) {
                continue;
            }
            Finding finding;
            finding.kind = FindingKind::NotSymmetric;
            finding.subject = subjectOf(*garment_.pieces[i]);
            finding.pieces = {static_cast<int>(i)};
            found_.add(std::move(finding));
        }
    }

    void checkFacings() {
        if (!isOfGarment(plan_.pattern.get())) {
            return;
        }
        for (const FacingPiece& facing : plan_.pattern->facings) {
            if (facing.strip.outline.rows() == 0) {
                Finding finding;
                finding.kind = FindingKind::NoFacing;
                finding.severity = Severity::Doubt;
                finding.subject =
                    subjectOf(*garment_.pieces[static_cast<std::size_t>(facing.piece)]);
                finding.pieces = {facing.piece};
                found_.add(std::move(finding));
            }
        }
    }

    bool isOfGarment(const Pattern* pattern) const {
        return pattern && pattern->pieces.size() == garment_.pieces.size();
    }

    /// The line that is cut, in the piece's coordinates: with allowances if they are known.
    Points2 cutOutline(std::size_t piece, const PieceResult& result) const {
        const bool isKnown =
            isOfGarment(plan_.pattern.get()) && plan_.pattern->pieces[piece].outline.rows() > 0;
        return isKnown ? edgeOf(plan_.pattern->pieces[piece])
                       : Points2(result.flat->Q(result.piece->boundary, Eigen::all));
    }

    /// Checks that the pieces fit their cloth. @return how much of each cloth is needed
    std::vector<ClothNeed> checkCloth() {
        if (!isOfGarment(plan_.pattern.get())) {
            return {};
        }
        const LaidOutPattern laid =
            cutAndPlace(*plan_.pattern, plan_.settings, plan_.materials, plan_.fabric);
        for (const WidePiece& wide :
             widerThanCloth(laid.wholePattern, plan_.fabric, plan_.rules, progress_)) {
            Finding finding;
            finding.kind = FindingKind::WiderThanCloth;
            finding.severity = Severity::Doubt;
            finding.subject =
                wide.facing.empty()
                    ? subjectOf(*garment_.pieces[static_cast<std::size_t>(wide.piece)])
                    : Subject::piece(wide.facing);
            finding.pieces = {wide.piece};
            finding.figures = {length(wide.extent), length(wide.room)};
            finding.badness = wide.extent - wide.room;
            found_.add(std::move(finding));
        }
        return clothNeeds(laid, plan_.fabric);
    }

    void checkSheet() {
        std::vector<Points2> outlines(garment_.pieces.size());
        for (std::size_t i = 0; i < outlines.size(); ++i) {
            const PieceResult* result = resultOf(static_cast<int>(i));
            const auto placement = settingsOf(static_cast<int>(i)).placement;
            if (!result || !result->flat || !placement) {
                continue;  // not placed yet: it will be placed beside the others
            }
            outlines[i] = placedLine(cutOutline(i, *result), *placement);
        }
        for (const auto& [one, other] : overlappingOutlines(outlines)) {
            Finding finding;
            finding.kind = FindingKind::PiecesOverlap;
            finding.severity = Severity::Doubt;
            finding.subject.name =
                nameOf(plan_.labels, *garment_.pieces[static_cast<std::size_t>(one)]) + " / " +
                nameOf(plan_.labels, *garment_.pieces[static_cast<std::size_t>(other)]);
            finding.pieces = {one, other};
            found_.add(std::move(finding));
        }
    }

    const CutPlan& plan_;
    const Garment& garment_;
    const Progress& progress_;
    FindingList found_;
};

}  // namespace

Readiness readyToCut(const CutPlan& plan, const Progress& progress) {
    return plan.garment ? Checks(plan, progress).run() : Readiness{};
}

}  // namespace toile
