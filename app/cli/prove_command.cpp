// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iosfwd>
#include <optional>
#include <ostream>
#include <string>
#include <utility>

#include "app/cli/command_line.h"
#include "core/base/characters.h"
#include "core/base/file.h"
#include "core/base/progress.h"
#include "core/base/text.h"
#include "core/formats/read_pattern.h"
#include "core/prove/body_file.h"
#include "core/prove/proof.h"
#include "core/toile/improve.h"

namespace toile::app {
namespace {

/// "round 2: 0.31 mm from the design on average, 95 % within 1.20 mm, 4.10 mm at most; 18 % less".
void printRound(const ImproveRound& round, std::ostream& out) {
    constexpr int kDecimals = 2;
    out << (round.number == 0 ? "before" : "round " + std::to_string(round.number)) << ": "
        << fixed(round.gap.mean, kDecimals) << " mm from the design on average, 95 % within "
        << fixed(round.gap.most95, kDecimals) << " mm, " << fixed(round.gap.max, kDecimals)
        << " mm at most";
    if (round.number > 0) {
        out << "; " << fixed(100 * std::abs(round.gain), 1) << " % "
            << (round.gain < 0 ? "more, so not kept" : "less");
    }
    out << std::endl;  // flush, because a round takes long
}

void printEnd(const Improved& improved, std::ostream& out) {
    switch (improved.ended) {
        case ImproveEnd::Rounds:
            break;
        case ImproveEnd::LittleGain:
            out << "the last round gained less than " << fixed(100 * kMinGain, 0) << " %\n";
            break;
        case ImproveEnd::GapGrows:
            out << "further rounds only make it worse\n";
            break;
        case ImproveEnd::NotFlat:
            out << "the next round failed: " << sentence(*improved.why) << '\n';
            break;
    }
    out << (improved.gain() > 0 ? "improved by " + fixed(100 * improved.gain(), 1) + " %"
                                : "not improved, so the pattern is unchanged")
        << "\n\n";
}

/// Improves the pattern; prints a line per round, and one about the end. Errors: as
/// `improvePattern`.
Result<Improved> improved(const Arguments& arguments, const Garment& garment,
                          const PieceResults& results, const ProofOrder& proof, Progress& progress,
                          std::ostream& out) {
    ImproveOrder order;
    order.proof = proof;
    order.pattern = orderOf(arguments, garment);
    order.rounds = arguments.prove.rounds;
    order.watch = [&out](const ImproveRound& round) { printRound(round, out); };
    auto made = improvePattern(garment, results, order, progress);
    if (made) {
        printEnd(*made, out);
    }
    return made;
}

constexpr int kGapDecimals = 2, kPercentDecimals = 1;
constexpr double kShownSlip = 0.05;  // mm: smaller ones print as 0.0

std::string percentText(double share) {
    return fixed(100 * share, kPercentDecimals);
}

void printProvenPieces(const Garment& garment, const Proof& proof, std::ostream& out) {
    Table table({"piece", "gap mm mean", "95 %", "max", "pulls %", "slack %", "free %"});
    for (std::size_t p = 0; p < proof.pieces.size(); ++p) {
        const ProvenPiece& piece = proof.pieces[p];
        const std::string& name = garment.pieces[p]->name;
        if (piece.isSewn()) {
            const sew::SpreadFigures& gap = piece.gapFigures;
            table.add({name, fixed(gap.mean, kGapDecimals), fixed(gap.most95, kGapDecimals),
                       fixed(gap.max, kGapDecimals), percentText(piece.mostPull),
                       percentText(piece.mostSlack), percentText(piece.freeShare)});
        } else {
            table.add({name, "-", "-", "-", "-", "-", "not sewn"});
        }
    }
    table.print(out);
}

/// Prints the worst seam first; nothing if all fit.
void printSlips(const Garment& garment, const Proof& proof, std::ostream& out) {
    std::vector<ProvenSeam> slips;
    std::ranges::copy_if(proof.seams, std::back_inserter(slips),
                         [](const ProvenSeam& seam) { return std::abs(seam.slip) >= kShownSlip; });
    if (slips.empty()) {
        return;
    }
    std::ranges::stable_sort(slips, std::greater(),
                             [](const ProvenSeam& seam) { return std::abs(seam.slip); });
    out << '\n';
    Table table({"seam that slips", "left mm", "right mm", "slip mm", "strain %"});
    for (const ProvenSeam& seam : slips) {
        table.add({garment.seams.seams[static_cast<std::size_t>(seam.seam)].name,
                   fixed(seam.left, 1), fixed(seam.right, 1), fixed(seam.slip, 1),
                   percentText(seam.strain)});
    }
    table.print(out);
}

void printHow(const Proof& proof, std::ostream& out) {
    out << "sewn from: " << shownText(proof.source, kMaxOfPlace) << "; "
        << shownText(howHeld(proof), kMaxOfPlace) << "; " << counted(proof.triangles, "triangle")
        << " with edges of " << fixed(proof.edge, 1) << " mm; "
        << (proof.hasSettled ? "settled in " : "not settled after ")
        << counted(proof.iterations, "step") << ", " << fixed(100 * restShare(proof), 3)
        << " % of the force at seams is left; " << fixed(proof.seconds, 1) << " s\n";
}

/// Prints a summary, a table of the pieces, the seams whose sides do not fit, the faults, and the
/// method.
void printProof(const Garment& garment, const Proof& proof, std::ostream& out) {
    out << shownText(sentence(proof, garment), kMaxOfPlace) << ".\n\n";
    printProvenPieces(garment, proof, out);
    printSlips(garment, proof, out);
    out << '\n';
    for (const Finding& fault : proof.faults) {
        out << "fault: " << shownText(fault.reason, kMaxOfPlace) << '\n';
    }
    printHow(proof, out);
}

constexpr double kBetweenSteps = 5;  // s, between progress messages

DrawProof drawProof = nullptr;

Result<void> writeProofFiles(const Arguments& arguments, const ExportSource& source,
                             const std::shared_ptr<const Proof>& proof, Messages& messages) {
    const auto write = [&messages](const std::filesystem::path& path,
                                   const std::string& bytes) -> Result<void> {
        auto written = writeFile(path, bytes);
        if (written) {
            messages.stream() << "wrote " << path.string() << '\n';
        }
        return written;
    };
    if (!arguments.report.empty()) {
        if (auto written = write(arguments.report, writeProof(source.garment(), *proof));
            !written) {
            return written;
        }
    }
    for (const auto& output : arguments.outputs) {
        if (!isPicture(output)) {
            continue;
        }
        const std::string png = drawProof(source, proof, arguments);
        if (png.empty()) {
            return Error{ErrorCode::FileUnwritable, Subject::file(output.string()),
                         "OpenGL is not available for drawing"};
        }
        if (auto written = write(output, png); !written) {
            return written;
        }
    }
    return {};
}

std::vector<std::filesystem::path> patternsAmong(std::vector<std::filesystem::path> outputs) {
    std::erase_if(outputs, isPicture);
    return outputs;
}

/// Reports progress from time to time.
std::function<void(const std::vector<Points3>&)> teller(Messages& messages) {
    return [&messages, watch = Stopwatch(), steps = 0,
            said = 0.0](const std::vector<Points3>&) mutable {
        ++steps;
        if (watch.seconds() >= said + kBetweenSteps) {
            said = watch.seconds();
            messages.add(fixed(said, 0) + " s, " + counted(steps, "step"));
        }
    };
}

/// The pattern file to sew instead of the garment's own; empty: none.
std::filesystem::path sewnFile(const Arguments& arguments) {
    if (!arguments.pattern.empty()) {
        return arguments.pattern;
    }
    const bool isReference = arguments.prove.plan.sewn == SewnPattern::Reference &&
                             arguments.project && arguments.project->reference;
    return isReference ? arguments.project->reference->path : std::filesystem::path();
}

}  // namespace

void provideProofPictures(DrawProof draw) {
    drawProof = draw;
}

DrawProof proofPictures() {
    return drawProof;
}

int runProve(const Arguments& arguments, std::ostream& out, Messages& messages) {
    Progress progress;
    auto interruptible = std::make_optional<Interruptible>(progress);
    const auto garment = readInput(arguments, progress, messages);
    if (!garment) {
        return kExitUnreadable;
    }
    const ProveArguments& typed = arguments.prove;
    auto ordered = proofOrder(arguments, *garment, progress);
    if (!ordered) {
        return refuse(ordered.refusal(), messages);
    }
    ProofOrder& order = *ordered;
    if (order.file) {
        const bool isTyped = !arguments.pattern.empty();
        reportPatternNotes(isTyped ? arguments.pattern : arguments.project->reference->path,
                           *order.file, messages);
    }
    order.watch = teller(messages);
    progress.start(1);
    PieceResults results = flattened(arguments, *garment, progress);
    if (progress.isCancelled()) {
        return refuse(Error{ErrorCode::Cancelled}, messages);
    }
    int status = reportProblems(*garment, messages) ? kExitSomeFailed : kExitDone;
    status = reportFailures(results, messages) ? kExitSomeFailed : status;
    if (!order.isReference && refusalOfNoPattern(results)) {
        messages.add("no piece could be flattened, so there is nothing to sew.");
        return kExitSomeFailed;
    }
    std::ostream& told = arguments.json ? messages.stream() : out;
    std::shared_ptr<const Proof> best;
    if (typed.rounds > 0) {
        auto made = improved(arguments, *garment, results, order, progress, told);
        if (!made) {
            return refuse(made.error(), messages);
        }
        results = std::move(made->results);
        best = std::move(made->proof);
    }
    const FinishedPattern made = finished(arguments, *garment, results);
    const ExportSource source = made.source(arguments.exporting);
    const auto proof =
        best ? Result<std::shared_ptr<const Proof>>(best) : proofOf(source, order, progress);
    interruptible.reset();  // from now on, Ctrl-C ends the program
    if (progress.isCancelled()) {
        return refuse(Error{ErrorCode::Cancelled}, messages);
    }
    if (!proof && proof.error().code == ErrorCode::NoGeometry) {  // in the pattern, not a mesh
        const auto& read = arguments.pattern.empty() ? arguments.inputs.front() : arguments.pattern;
        messages.add(shownText(read.string(), kMaxOfPlace) + ": " +
                     shownText(proof.error().detail, kMaxOfDetail) + ".");
        return kExitUnreadable;
    }
    if (!proof) {
        return refuse(proof.error(), messages);
    }
    if (arguments.json) {
        out << writeProof(*garment, **proof);
    } else {
        printProof(*garment, **proof, out);
    }
    if (!(*proof)->hasSettled) {
        messages.add("doubt: the cloth has not settled after " +
                     counted((*proof)->iterations, "step") +
                     ", so the figures are not reliable. Use longer edges with --edge.");
    }
    const bool isDone = (*proof)->faults.empty() && (*proof)->hasSettled;
    status = isDone ? status : kExitSomeFailed;
    if (const auto written = writeProofFiles(arguments, source, *proof, messages); !written) {
        return refuse(written.error(), messages);
    }
    if (typed.rounds > 0 &&
        !writePatterns(patternsAmong(arguments.outputs), source, told, messages)) {
        status = kExitUnreadable;
    }
    out.flush();
    return out ? status : kExitUnreadable;
}

Answer<ProofOrder> orderOfOwn(const Arguments& arguments, const Garment& garment,
                              Progress& progress) {
    const ProofPlan& plan = arguments.prove.plan;
    ProofOrder order{.settings = plan.settings, .scale = arguments.prove.scale};
    if (plan.body.empty()) {
        return order;
    }
    auto body = readBody(plan.body, plan.bodyUnit, garment, progress);
    if (!body) {
        return body.error();
    }
    if (!isNear(*body, garment)) {
        return Refusal(kNotProved,
                       "\"" + shownText(plan.body.string(), kMaxOfPlace) +
                           "\" is far from the garment; set its unit with --body-unit.",
                       plan.body.string());
    }
    order.body = std::move(*body);
    order.bodyName = plan.body.filename().string();
    return order;
}

std::vector<std::string> notesOf(const ProofOrder& order) {
    std::vector<std::string> notes;
    for (const Wording& note : order.file ? order.file->notes : std::vector<Wording>{}) {
        notes.push_back(shownText(note, kMaxOfDetail));
    }
    return notes;
}

Answer<ProofOrder> proofOrder(const Arguments& arguments, const Garment& garment,
                              Progress& progress) {
    const ProofPlan& plan = arguments.prove.plan;
    const std::filesystem::path file = sewnFile(arguments);
    const bool isDesigners = file.empty() && plan.sewn == SewnPattern::Designer;
    const auto hasPanel = [](const auto& piece) { return piece->reference.has_value(); };
    if (isDesigners && std::ranges::none_of(garment.pieces, hasPanel)) {
        const std::string way =
            arguments.project ? "use --reference none" : "leave out --reference";
        return Refusal(kNotProved, "the garment has no reference panels; " + way + ".");
    }
    std::optional<PatternFile> pattern;
    if (!file.empty()) {
        auto read = readPatternFile(file, arguments.prove.patternUnit);
        if (!read) {
            return read.error();
        }
        pattern = std::move(*read);
    }
    auto ordered = orderOfOwn(arguments, garment, progress);
    if (ordered) {
        ordered->isReference = isDesigners;
        ordered->file = std::move(pattern);
    }
    return ordered;
}

Refusal refusalOfProof(const Error& error, const PieceResults& results) {
    const auto noPattern = refusalOfNoPattern(results);
    return error.code == ErrorCode::NoGeometry && noPattern ? *noPattern : Refusal(error);
}

}  // namespace toile::app
