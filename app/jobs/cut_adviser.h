// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "app/base/worker.h"
#include "core/base/result.h"
#include "core/flatten/base/flat_piece.h"
#include "core/garment/garment.h"
#include "core/tailor/cut_advice.h"

namespace toile::app {

/// A piece to propose cuts for.
struct AdviceQuestion {
    std::shared_ptr<const Piece> piece{};
    std::vector<UserCut> own{};                ///< cuts that are made in any case, mm
    std::shared_ptr<const SourceFile> file{};  ///< of the piece; cuts follow its borders
    AdviceOptions options{};                   ///< without borders

    bool operator==(const AdviceQuestion&) const = default;
};

/// Finds cuts worth making on one thread, and flattens their results, one after the other, on
/// another. A new question replaces the one before. GUI thread only.
class CutAdviser : public QObject {
    Q_OBJECT

public:
    CutAdviser();

    bool isAsking() const { return asking_.isBusy(); }
    bool isSolving() const { return !counts_.empty(); }
    /// Progress of the question, in [0, 1].
    double fraction() const { return asking_.progress() ? asking_.progress()->fraction() : 0; }

    void ask(AdviceQuestion question);
    /// Flattens the piece with the first so many cuts made, for each of these counts.
    void solve(AdviceQuestion question, CutAdvice advice, std::vector<std::size_t> counts,
               FlattenOptions options);
    /// Returns at once; no answer comes any more.
    void cancel();
    void cancelSolving();

signals:
    void advised(const toile::CutAdvice& advice);
    void solved(std::size_t count, const toile::StrainFigures& figures);
    /// The last count is done.
    void solvedAll();
    void failed(const QString& sentence);

private:
    /// A piece to flatten with some cuts made.
    struct Trial {
        std::shared_ptr<const std::pair<AdviceQuestion, CutAdvice>> cuts;
        FlattenOptions options{};
        std::size_t count = 0;

        bool operator==(const Trial&) const = default;
    };

    void solveNext();

    Trial trial_;
    std::vector<std::size_t> counts_;  ///< remaining ones, the next one first
    Follower<AdviceQuestion, CutAdvice> asking_;
    Follower<Trial, Result<StrainFigures>> solving_;
};

}  // namespace toile::app
