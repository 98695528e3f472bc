// SPDX-License-Identifier: GPL-3.0-or-later
// Commands about the flat pattern: flatten, check and walk.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <ostream>
#include <utility>

#include "app/cli/command_line.h"
#include "core/base/characters.h"
#include "core/base/text.h"
#include "core/check/ready_to_cut.h"
#include "core/diagnose/doubt.h"
#include "core/diagnose/finding.h"
#include "core/formats/tables/report_tables.h"
#include "core/pattern/walk.h"
#include "core/project/place_pieces.h"
#include "core/project/project.h"
#include "core/project/rigid_motion.h"
#include "core/prove/proof.h"
#include "core/seam/seam_measure.h"
#include "core/symmetry/symmetry.h"
#include "core/toile/pipeline.h"

namespace toile::app {
namespace {

constexpr double kSquareMillimetresPerSquareCentimetre = 100;
constexpr double kMillimetresPerCentimetre = 10;
constexpr double kMillisecondsPerSecond = 1000;

/// Boundary errors span ten orders of magnitude, so one digit and the exponent suffice.
std::string scientific(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.0e", value);
    return text;
}

std::string percent(const std::optional<double>& fraction) {
    return fraction ? fixed(100 * *fraction, 2) : "-";
}

std::vector<std::string> rowOf(const PieceResult& result) {
    const Piece& piece = *result.piece;
    std::vector<std::string> row{piece.name, std::to_string(piece.mesh.F.rows())};
    if (!result.quality) {
        row.insert(row.end(), {"-", "-", "-", "-", "-", "-", "-", "-", "-",
                               isLeftOut(result) ? "left out" : "failed"});
        return row;
    }
    const PieceQuality& q = *result.quality;
    const std::string changes = changeWords(changesOf(result));
    row.insert(row.end(), {fixed(q.area2d / kSquareMillimetresPerSquareCentimetre, 1),
                           fixed(q.perimeter2d / kMillimetresPerCentimetre, 1),
                           scientific(q.maxBoundaryLengthError), changes.empty() ? "-" : changes,
                           percent(q.strainMin), percent(q.strainMax), percent(q.strainMeanAbs),
                           std::to_string(q.flippedTriangles), std::to_string(q.outlineCrossings),
                           fixed(kMillisecondsPerSecond * result.seconds, 1)});
    return row;
}

void printResults(const PieceResults& results, std::ostream& out) {
    Table table({"piece", "triangles", "area cm2", "outline cm", "length error", "changed by",
                 "strain % least", "most", "mean size", "flips", "crossings", "ms"});
    for (const auto& result : results) {
        table.add(rowOf(*result));
    }
    table.print(out);
}

/// Prints one line: number of seams, and the largest error.
void printSeamSummary(const Garment& garment, const PieceResults& results, std::ostream& out) {
    const std::vector<MeasuredSeam> rows = seamsByError(garment, results);
    if (rows.empty()) {
        return;
    }
    out << counted(static_cast<long long>(rows.size()), "seam") << ", largest error "
        << fixed(std::abs(rows.front().measure.errorMm), 2) << " mm ("
        << shownText(rows.front().seam->name) << ")\n";
}

/// One line: the widths of allowances beside free edges, by kind, and usual ones that do not fit.
void printEdges(const Pattern& pattern, std::ostream& out) {
    std::string text;
    for (const auto& [kind, word] : kEdgeKindWords) {
        double least = HUGE_VAL, most = 0, usual = 0;
        for (const PatternPiece& piece : pattern.pieces) {
            for (const PatternSegment& segment : piece.segments) {
                if (segment.seam > 0 && segment.kind == SeamKind::Free && segment.edge == kind) {
                    const bool isLimited = segment.limit != AllowanceLimit::None;
                    least = std::min(least, segment.allowance);
                    most = std::max(most, segment.allowance);
                    usual = std::max(usual, isLimited ? segment.usualAllowance : 0);
                }
            }
        }
        if (pattern.hasAllowance && least <= most) {
            out << (text.empty() ? "free edges: " : ", ") << word << ' '
                << (least < most ? numberText(least) + " to " : "") << numberText(most) << " mm"
                << (usual > 0 ? " (usual " + numberText(usual) + " does not fit)" : "");
            text = "\n";
        }
    }
    out << text;
}

/// Prints pieces not mirrored because their seams differ too much, and the option that helps.
void printUnequal(const Garment& garment, const Symmetry* symmetry, std::ostream& out) {
    if (!symmetry || symmetry->kept.empty() || symmetry->unequal.empty()) {
        return;
    }
    const auto seamName = [&garment](int seam) -> std::string {
        return shownText(garment.seams.seams[seam].name);
    };
    for (const UnequalPieces& one : symmetry->unequal) {
        out << "not mirrored: " << shownText(garment.pieces[one.piece]->name);
        if (one.piece == one.counterpart) {
            out << ", its two halves";
        } else {
            out << " and " << shownText(garment.pieces[one.counterpart]->name);
        }
        out << "; seam " << seamName(one.seam) << " is " << fixed(one.difference, 1)
            << " mm longer than " << seamName(one.mirrored) << " (tolerance "
            << fixed(one.tolerance, 1) << " mm)\n";
    }
    out << "they keep their shapes from the file; use --mirror equal to make them equal\n";
}

/// Prints a line per finding; the same finding about several pieces or seams shares one.
void printFindings(const Readiness& readiness, std::ostream& out) {
    const auto& findings = readiness.findings;
    for (std::size_t i = 0; i < findings.size();) {
        Finding told = findings[i];
        std::string& names = told.subject.name;
        names = shownText(names, kMaxOfPlace);
        for (++i; i < findings.size() && findings[i].severity == told.severity &&
                  findings[i].kind == told.kind && !names.empty() &&
                  description(findings[i]) == description(told) &&
                  adviceFor(findings[i]) == adviceFor(told);
             ++i) {
            names += ", " + shownText(findings[i].subject.name, kMaxOfPlace);
        }
        out << name(told.severity) << ": " << sentence(told) << '\n';
    }
}

/// Sews the pattern back together; reports a failure and returns null.
std::shared_ptr<const Proof> proved(const Arguments& arguments, const CutPlan& plan,
                                    Progress& progress, Messages& messages) {
    const auto ordered = orderOfOwn(arguments, *plan.garment, progress);
    if (!ordered) {
        refuse(ordered.refusal(), messages);
        return nullptr;
    }
    const FinishedPattern made = finished(arguments, *plan.garment, plan.results);
    const auto proof = proofOf(made.source(arguments.exporting), *ordered, progress);
    if (!proof) {
        refuse(refusalOfProof(proof.error(), plan.results), messages);
        return nullptr;
    }
    return *proof;
}

using Notches = std::vector<std::vector<Notch>>;

/// Prints one line: number of seams and notches, and the largest error.
void printSummary(const Garment& garment, const Notches& notches,
                  const std::vector<SeamWalk>& walks, std::ostream& out) {
    const auto worst = std::ranges::max_element(walks, {}, &SeamWalk::largestError);
    if (worst == walks.end()) {
        out << "no seam to walk\n";
        return;
    }
    long long count = 0;
    for (const auto& ofSeam : notches) {
        count += static_cast<long long>(ofSeam.size());
    }
    const Seam& seam = garment.seams.seams[static_cast<std::size_t>(worst->seam)];
    out << counted(static_cast<long long>(walks.size()), "seam") << ", "
        << (count == 1 ? "1 notch" : std::to_string(count) + " notches") << ", largest error "
        << fixed(worst->largestError(), 6) << " mm (" << shownText(seam.name) << ")\n";
}

}  // namespace

int runFlatten(const Arguments& arguments, std::ostream& out, Messages& messages) {
    Progress progress;
    const auto garment = readInput(arguments, progress, messages);
    if (!garment) {
        return kExitUnreadable;
    }
    const PieceResults results = flattened(arguments, *garment, progress);
    printCuts(*garment, out);
    printResults(results, out);
    printSeamSummary(*garment, results, out);
    if (arguments.ledger) {
        out << '\n';
        printTable(ledgerTable(*garment, results), out);
    }
    reportProblems(*garment, messages);
    reportFailures(results, messages);
    const FinishedPattern made = finished(arguments, *garment, results);
    const Pattern& pattern = made.laid.pattern;
    if (arguments.ledger && pattern.hasAllowance) {
        out << '\n';
        printTable(edgeTable(pattern), out);
    }
    printEdges(pattern, out);
    printUnequal(*garment, pattern.symmetry.get(), out);
    const auto doubts = findDoubts(*garment, results, fabricsOf(pattern, made.fabric));
    for (const Finding& doubt : doubts) {
        messages.add(std::string(name(doubt.severity)) + ": " + sentence(doubt));
    }
    const bool lacksMemory = std::ranges::any_of(results, [](const auto& result) -> bool {
        return result->error && result->error->code == ErrorCode::OutOfMemory;
    });
    const bool isRefused =
        hasFaults(*garment, results, doubts) || (arguments.failOnDoubt && !doubts.empty());
    int status = lacksMemory ? kExitUnreadable : isRefused ? kExitSomeFailed : kExitDone;
    if (!writePatterns(arguments.outputs, made.source(arguments.exporting), out, messages)) {
        status = kExitUnreadable;
    }
    out.flush();
    return out ? status : kExitUnreadable;
}

int runCheck(const Arguments& arguments, std::ostream& out, Messages& messages) {
    Progress progress;
    auto read = readInput(arguments, progress, messages);
    if (!read) {
        return kExitUnreadable;
    }
    CutPlan plan;
    plan.garment = std::make_shared<const Garment>(std::move(*read));
    plan.options = arguments.options;
    plan.lines = arguments.lines;
    plan.results = flattened(arguments, *plan.garment, progress);
    plan.pattern = std::make_shared<const Pattern>(makePattern(
        *plan.garment, plan.results, plan.lines, symmetryOf(*plan.garment, plan.lines)));
    const PatternOrder order = orderOf(arguments, *plan.garment);
    plan.fabric = order.fabric;
    plan.settings = settingsOf(order, *plan.garment);
    for (std::size_t i = 0; i < plan.settings.size(); ++i) {
        if (plan.results[i]->flat) {
            plan.settings[i] =
                anchoredSettings(std::move(plan.settings[i]), plan.results[i]->flat->Q);
        }
    }
    plan.materials = materialsOf(order, plan.settings);
    if (order.lines.grain) {
        setGrains(plan.settings, *plan.garment, plan.results, plan.pattern->symmetry.get(),
                  *order.lines.grain, plan.materials, plan.fabric);
    }
    if (arguments.project) {
        plan.rules = clothRules(arguments.project->markers);
    }
    if (arguments.isProving) {
        plan.proof = proved(arguments, plan, progress, messages);
    }
    const Readiness readiness = readyToCut(plan, progress);
    if (arguments.json) {
        out << writeReadiness(*plan.garment, readiness);
    } else {
        out << verdictText(readiness) << '\n';
        printFindings(readiness, out);
        for (const ClothNeed& need : readiness.cloth) {
            out << "cloth: " << sentence(need) << '\n';
        }
    }
    out.flush();
    const bool isProved = !arguments.isProving || plan.proof != nullptr;
    const bool isReady = isProved && readiness.count(Severity::Fault) == 0 &&
                         !(arguments.failOnDoubt && readiness.count(Severity::Doubt) > 0);
    return !out ? kExitUnreadable : isReady ? kExitDone : kExitSomeFailed;
}

int runWalk(const Arguments& arguments, std::ostream& out, Messages& messages) {
    Progress progress;
    const auto garment = readInput(arguments, progress, messages);
    if (!garment) {
        return kExitUnreadable;
    }
    const LineSettings& lines = arguments.lines;
    const PieceResults results = flattened(arguments, *garment, progress);
    const auto [notches, walks] = walkGarment(
        *garment, results, makePattern(*garment, results, lines, symmetryOf(*garment, lines)),
        lines.notches);
    if (arguments.json) {
        out << writeWalk(*garment, notches, walks);
    } else {
        printTable(walkTable(*garment, notches, walks), out);
        printSummary(*garment, notches, walks, out);
    }
    const bool areProblems = reportProblems(*garment, messages);
    const bool areFailures = reportFailures(results, messages);
    const bool areUnequal = std::ranges::any_of(
        walks, [](const SeamWalk& walk) { return !(walk.largestError() <= kWalkTolerance); });
    out.flush();
    return !out                                       ? kExitUnreadable
           : areProblems || areFailures || areUnequal ? kExitSomeFailed
                                                      : kExitDone;
}

}  // namespace toile::app
