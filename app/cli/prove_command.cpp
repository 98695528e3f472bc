// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <iosfwd>
#include <optional>
#include <ostream>
#include <utility>

#include "app/cli/arguments.h"
#include "app/cli/check_arguments.h"
#include "app/cli/command_line.h"
#include "app/cli/input.h"
#include "app/cli/marker_interruptible.h"
#include "app/cli/proof_order.h"
#include "app/cli/proof_picture.h"
#include "app/cli/write_patterns.h"
#include "core/base/characters.h"
#include "core/base/file.h"
#include "core/base/progress.h"
#include "core/base/text.h"
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
    out << std::endl;  // a round takes its time
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

/// The pattern of a garment made to fit it better, as the arguments ask; a line per round, and one
/// on how it ended. Errors: those of `improvePattern`.
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
constexpr double kShownSlip = 0.05;  // mm: from here on it is not 0.0

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

/// The worst first; nothing where all fit.
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

/// The sentence, a table of the pieces, the seams whose sides do not fit each other, the faults,
/// and how all was found.
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

constexpr double kBetweenSteps = 5;  // s, of the lines that say how far it is

DrawProof drawProof = nullptr;

Result<void> writeProofFiles(const Arguments& arguments, const ExportSource& source,
                             const std::shared_ptr<const Proof>& proof, std::ostream& err) {
    const auto write = [&err](const std::filesystem::path& path,
                              const std::string& bytes) -> Result<void> {
        auto written = writeFile(path, bytes);
        if (written) {
            err << "wrote " << path.string() << '\n';
        }
        return written;
    };
    if (!arguments.prove.report.empty()) {
        if (auto written = write(arguments.prove.report, writeProof(source.garment(), *proof));
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

/// Says once in a while how far it is.
std::function<void(const std::vector<Points3>&)> teller(std::ostream& err) {
    return [&err, watch = Stopwatch(), steps = 0, said = 0.0](const std::vector<Points3>&) mutable {
        ++steps;
        if (watch.seconds() >= said + kBetweenSteps) {
            said = watch.seconds();
            err << "toile: " << fixed(said, 0) << " s, " << counted(steps, "step") << '\n';
        }
    };
}

}  // namespace

void provideProofPictures(DrawProof draw) {
    drawProof = draw;
}

DrawProof proofPictures() {
    return drawProof;
}

int runProve(const Arguments& arguments, std::ostream& out, std::ostream& err) {
    Progress progress;
    auto interruptible = std::make_optional<Interruptible>(progress);
    const auto garment = readInput(arguments, progress, err);
    if (!garment) {
        return kExitUnreadable;
    }
    const ProveArguments& typed = arguments.prove;
    auto ordered = proofOrder(arguments, *garment, progress);
    if (const auto* refusal = std::get_if<Refusal>(&ordered)) {
        return refuse(*refusal, err);
    }
    ProofOrder& order = std::get<ProofOrder>(ordered);
    if (order.file) {
        const bool isTyped = !arguments.pattern.empty();
        printPatternNotes(isTyped ? arguments.pattern : arguments.project->reference->path,
                          *order.file, err);
    }
    order.watch = teller(err);
    progress.start(1);
    PieceResults results = flattened(arguments, *garment, progress);
    if (progress.isCancelled()) {
        return refuse(Error{ErrorCode::Cancelled}, err);
    }
    int status = printProblems(*garment, err) ? kExitSomeFailed : kExitDone;
    status = printFailures(results, err) ? kExitSomeFailed : status;
    const auto isFlat = [](const PieceResults::value_type& result) {
        return result->flat.has_value();
    };
    if (!order.isReference && std::ranges::none_of(results, isFlat)) {
        err << "toile: no piece could be flattened, so there is nothing to sew.\n";
        return kExitSomeFailed;
    }
    std::shared_ptr<const Proof> best;
    if (typed.rounds > 0) {
        auto made =
            improved(arguments, *garment, results, order, progress, arguments.json ? err : out);
        if (!made) {
            return refuse(made.error(), err);
        }
        results = std::move(made->results);
        best = std::move(made->proof);
    }
    const FinishedPattern made = finished(arguments, *garment, results);
    const ExportSource source = made.source(arguments.exporting);
    const auto proof =
        best ? Result<std::shared_ptr<const Proof>>(best) : proofOf(source, order, progress);
    interruptible.reset();  // from here on Ctrl-C ends the program
    if (progress.isCancelled()) {
        return refuse(Error{ErrorCode::Cancelled}, err);
    }
    if (!proof && proof.error().code == ErrorCode::NoGeometry) {  // of the pattern, not of a mesh
        const auto& read = arguments.pattern.empty() ? arguments.inputs.front() : arguments.pattern;
        err << "toile: " << shownText(read.string(), kMaxOfPlace) << ": "
            << shownText(proof.error().detail, kMaxOfDetail) << ".\n";
        return kExitUnreadable;
    }
    if (!proof) {
        return refuse(proof.error(), err);
    }
    if (arguments.json) {
        out << writeProof(*garment, **proof);
    } else {
        printProof(*garment, **proof, out);
    }
    status = (*proof)->faults.empty() ? status : kExitSomeFailed;
    if (const auto written = writeProofFiles(arguments, source, *proof, err); !written) {
        return refuse(written.error(), err);
    }
    if (typed.rounds > 0 &&
        !writePatterns(patternsAmong(arguments.outputs), source, arguments.json ? err : out, err)) {
        status = kExitUnreadable;
    }
    out.flush();
    return out ? status : kExitUnreadable;
}

}  // namespace toile::app
