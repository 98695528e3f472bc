// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/progress.h"
#include "core/diagnose/finding.h"
#include "core/flatten/base/piece_result.h"
#include "core/garment/fabric.h"
#include "core/garment/garment.h"
#include "core/layout/arrange.h"
#include "core/marker/cloth_fit.h"
#include "core/pattern/line_settings.h"
#include "core/project/piece_settings.h"

namespace toile {

/// Whether the cloth may be cut.
enum class Verdict {
    NotFlattened,  ///< the garment in its present state has no pattern
    Faults,
    Doubts,  ///< no faults, but something to check
    Ready,
};

/// All findings: the faults first, then by kind, the worst of a kind first.
struct Readiness {
    std::vector<Finding> findings{};
    std::vector<ClothNeed> cloth{};  ///< of flat pieces; empty without a pattern

    int count(Severity severity) const;
    Verdict verdict() const;
};

/// "not-flattened", "faults", "doubts", "ready".
std::string_view name(Verdict verdict);
/// "Ready to cut", "2 faults, 1 doubt", "No faults, 3 doubts", "Not flattened yet".
std::string verdictText(const Readiness& readiness);

/// Collects findings and sorts them.
class FindingList {
public:
    void add(Finding finding) { found_.push_back(std::move(finding)); }
    /// Adds an error or a note; its code decides whether it is a fault or a note.
    void add(const Error& error, std::vector<int> pieces);
    /// Takes all findings and leaves the list empty. Equal ones keep the order they were added in.
    Readiness inOrder();

private:
    std::vector<Finding> found_;
};

struct Proof;

/// What `readyToCut` checks. All members are immutable and shared, so a copy for another thread is
/// cheap.
struct CutPlan {
    std::shared_ptr<const Garment> garment{};  ///< null: no garment is open
    PieceResults results{};                    ///< one per piece, or null; or empty
    FlattenOptions options{};                  ///< with which the pieces are to be flattened
    LineSettings lines{};                      ///< with which the outlines are to be drawn
    Fabric fabric = fabricPresets().front();
    MaterialList materials{};                  ///< of pieces that are cut from another fabric
    std::shared_ptr<const Pattern> pattern{};  ///< of all the above; or null
    std::vector<PieceSettings> settings{};     ///< one per piece, without anchors; or empty
    PieceLabels labels{};                      ///< names of pieces in findings; or empty
    ClothRules rules{};                        ///< how pieces may lie on their cloth
    /// The pattern sewn back together, of exactly this garment and these results; or null.
    std::shared_ptr<const Proof> proof{};
    std::string referenceName{};            ///< of the file that the pieces are compared with
    std::vector<Wording> referenceNotes{};  ///< what reading it left out or put right
    bool guessesKept = false;  ///< unit and up axis, where guessed, are right: the user stated so

    bool operator==(const CutPlan&) const = default;
};

/// Kinks at the ends of seams are reported from this angle, radians; designers leave smaller ones.
inline constexpr double kTellingKink = 0.08726646259971647;  ///< 5 degrees

/// Largest extent of a garment, mm: larger than a doll's and smaller than a tent.
inline constexpr double kSmallestGarment = 10, kLargestGarment = 10000;

/// Checks everything that a pattern maker would before cutting; docs/ready-to-cut.md lists each
/// check and its rule. Seams are judged like in the ledger (core/seam/seam_measure.h). A piece
/// whose result is of another shape is skipped.
/// Cost: linear in the triangles, a tenth of a second for a million; n log n for outlines that
/// cross or lie near each other. Pure, thread-safe.
/// @param progress  polled between pieces; if it is cancelled, the findings are incomplete
Readiness readyToCut(const CutPlan& plan, const Progress& progress = Progress());

/// The verdict and all findings as JSON (docs/ready-to-cut.md). @param readiness  of this garment
std::string writeReadiness(const Garment& garment, const Readiness& readiness);

}  // namespace toile
