// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/improve_pattern.h"

#include <cmath>
#include <ostream>

#include "app/cli/arguments.h"
#include "app/cli/command_line.h"
#include "core/base/text.h"

namespace toile::app {
namespace {

/// "round 2: 0.31 mm from the design on average, 1.20 mm at the worst twentieth, 4.10 mm at most;
/// 18 % less".
void printRound(const ImproveRound& round, std::ostream& out) {
    constexpr int kDecimals = 2;
    out << (round.number == 0 ? "as it was" : "round " + std::to_string(round.number)) << ": "
        << fixed(round.gap.mean, kDecimals) << " mm from the design on average, "
        << fixed(round.gap.most95, kDecimals) << " mm at the worst twentieth, "
        << fixed(round.gap.max, kDecimals) << " mm at most";
    if (round.number > 0) {
        out << "; " << fixed(100 * std::abs(round.gain), 1) << " % "
            << (round.gain < 0 ? "more: not kept" : "less");
    }
    out << std::endl;  // a round takes its time
}

void printEnd(const Improved& improved, std::ostream& out) {
    switch (improved.ended) {
        case ImproveEnd::Rounds:
            break;
        case ImproveEnd::LittleGain:
            out << "the last round gained less than " << fixed(100 * kLeastGain, 0) << " %\n";
            break;
        case ImproveEnd::GapGrows:
            out << "further rounds only make it worse\n";
            break;
        case ImproveEnd::NotFlat:
            out << "another round could not be made: " << sentence(*improved.why) << '\n';
            break;
    }
    out << (improved.gain() > 0 ? "improved by " + fixed(100 * improved.gain(), 1) + " %"
                                : "not improved: the pattern stays as it was")
        << "\n\n";
}

}  // namespace

Result<Improved> improved(const Arguments& arguments, const Garment& garment,
                          const PieceResults& results, const ProofOrder& proof, Progress& progress,
                          std::ostream& out) {
    ImproveOrder order;
    order.proof = proof;
    order.flattening = arguments.options;
    order.lines = arguments.lines;
    order.fabric = arguments.fabric.value_or(order.fabric);
    order.layOut = [&](const PieceResults& of) { return laidOut(arguments, garment, of); };
    order.rounds = arguments.prove.rounds;
    order.watch = [&out](const ImproveRound& round) { printRound(round, out); };
    auto made = improvePattern(garment, results, order, progress);
    if (made) {
        printEnd(*made, out);
    }
    return made;
}

}  // namespace toile::app
