// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/compare_job.h"

#include <QCoreApplication>
#include <utility>

#include "app/render/scene_builder.h"

namespace toile {

namespace {

/// Of the job's time, about.
constexpr double kComparingShare = 0.8;

/// What is known, and the piece and those sewn to it.
PieceResults flattened(const CompareOrder& order, Progress& progress) {
    PieceResults results = order.known;
    std::vector<int> needed = sewnTo(*order.garment, order.piece);
    needed.push_back(order.piece);
    std::erase_if(needed,
                  [&](int piece) { return results[static_cast<std::size_t>(piece)] != nullptr; });
    Garment part;  // flattening looks at the pieces alone
    for (const int piece : needed) {
        part.pieces.push_back(order.garment->pieces[static_cast<std::size_t>(piece)]);
    }
    PieceResults found = flattenGarment(part, order.options, progress);
    for (std::size_t i = 0; i < needed.size(); ++i) {
        results[static_cast<std::size_t>(needed[i])] = std::move(found[i]);
    }
    return results;
}

struct Compared {
    ComparedPiece piece;
    PieceResults results;
};

}  // namespace

std::unique_ptr<Job> compareJob(
    CompareOrder order, std::function<void(ComparedPiece made, const PieceResults& results)> done) {
    auto work = [order = std::move(order)](Progress& progress) -> Result<Compared> {
        progress.setShare(0, kComparingShare);
        Compared made{{}, flattened(order, progress)};
        if (!progress.isCancelled()) {
            progress.setShare(kComparingShare, 1);
            ComparedPiece& piece = made.piece;
            piece.result = made.results[static_cast<std::size_t>(order.piece)];
            piece.figures = comparedPiece(*order.garment, made.results, order.piece);
            if (piece.result->flat) {
                Garment alone;
                alone.pieces = {piece.result->piece};
                piece.scene = buildScene(alone, {piece.result}, progress);
            }
        }
        return made;
    };
    auto taken = [done = std::move(done)](Compared made) {
        done(std::move(made.piece), made.results);
    };
    return makeJob(QCoreApplication::translate("CompareJob", "Comparing methods"), std::move(work),
                   std::move(taken));
}

}  // namespace toile
