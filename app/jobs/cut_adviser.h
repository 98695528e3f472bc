// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include "app/base/worker.h"
#include "core/base/result.h"
#include "core/flatten/base/flat_piece.h"
#include "core/garment/garment.h"
#include "core/tailor/cut_advice.h"

namespace toile::app {

/// What cuts are to be proposed for.
struct AdviceQuestion {
    std::shared_ptr<const Piece> piece{};
    std::vector<UserCut> own{};                ///< that are made anyhow, mm
    std::shared_ptr<const SourceFile> file{};  ///< of the piece: its borders speak for cuts
    AdviceOptions options{};                   ///< without borders

    bool operator==(const AdviceQuestion&) const = default;
};

/// Finds cuts worth making, on a thread of its own, and flattens what comes of them, one after the
/// other on another. What is asked anew takes the place of what was asked before. GUI thread only.
class CutAdviser : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;
    ~CutAdviser() override;

    bool isAsking() const { return asking_.isBusy() && !isDropped_; }
    bool isSolving() const { return !counts_.empty(); }
    /// Of what is asked, in [0, 1].
    double fraction() const;

    void ask(AdviceQuestion question);
    /// Flattens the piece with so many of the first cuts made, for each of these counts in turn.
    void solve(AdviceQuestion question, CutAdvice advice, std::vector<std::size_t> counts,
               FlattenOptions options);
    /// Nothing of it is heard any more. Returns at once.
    void cancel();
    void cancelSolving();

signals:
    void advised(const toile::CutAdvice& advice);
    void solved(std::size_t count, const toile::StrainFigures& figures);
    /// The last count is done.
    void solvedAll();
    void failed(const QString& sentence);

private:
    void startAsking();
    void startSolving();

    std::unique_ptr<AdviceQuestion> waiting_;
    bool isDropped_ = false;   ///< what is worked on is not wanted any more
    AdviceQuestion question_;  ///< of what is flattened
    CutAdvice advice_;
    FlattenOptions options_{};
    std::vector<std::size_t> counts_;  ///< to come, the next one first
    int round_ = 0;                    ///< of solving: answers of earlier ones are passed by
    Worker<CutAdvice> asking_;
    Worker<Result<StrainFigures>> solving_;
};

}  // namespace toile::app
