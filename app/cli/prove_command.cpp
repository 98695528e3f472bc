// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <optional>
#include <ostream>
#include <utility>

#include "app/cli/arguments.h"
#include "app/cli/check_arguments.h"
#include "app/cli/command_line.h"
#include "app/cli/improve_pattern.h"
#include "app/cli/input.h"
#include "app/cli/marker_interruptible.h"
#include "app/cli/proof_order.h"
#include "app/cli/proof_picture.h"
#include "app/cli/prove_text.h"
#include "app/cli/write_patterns.h"
#include "core/base/characters.h"
#include "core/base/file.h"
#include "core/base/stopwatch.h"
#include "core/base/text.h"

namespace toile::app {
namespace {

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
                         "there is no OpenGL to draw with"};
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
        err << "toile: no piece lies flat: there is nothing to sew.\n";
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
    const LaidOutPattern laid = laidOut(arguments, *garment, results);
    const ExportSource source(*garment, results, laid, arguments.exporting, {}, arguments.lines,
                              arguments.fabric.value_or(fabricPresets().front()));
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
