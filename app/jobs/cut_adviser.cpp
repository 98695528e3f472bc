// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/cut_adviser.h"

#include <utility>

#include "app/text/error_text.h"
#include "core/tailor/mesh_lines.h"
#include "core/toile/pipeline.h"

namespace toile::app {

CutAdviser::~CutAdviser() = default;

double CutAdviser::fraction() const {
    return isAsking() ? asking_.progress()->fraction() : 0;
}

void CutAdviser::ask(AdviceQuestion question) {
    cancel();
    waiting_ = std::make_unique<AdviceQuestion>(std::move(question));
    startAsking();
}

void CutAdviser::startAsking() {
    if (!waiting_ || asking_.isBusy()) {
        return;  // that was cancelled, and this follows
    }
    isDropped_ = false;
    const auto question = std::exchange(waiting_, nullptr);
    asking_.start(
        [asked = *question](Progress& progress) {
            AdviceOptions options = asked.options;
            options.borders = fileBorders(*asked.piece, *asked.file->soup);
            return adviseCuts(asked.piece, asked.own, options, progress);
        },
        [this](const Attempt<CutAdvice>& made, const Progress& progress) {
            const bool isWanted = !isDropped_ && !progress.isCancelled();
            startAsking();
            if (isWanted && made.answer) {
                emit advised(*made.answer);
            } else if (isWanted) {
                emit failed(faultText(made.fault));
            }
        });
}

void CutAdviser::solve(AdviceQuestion question, CutAdvice advice, std::vector<std::size_t> counts,
                       FlattenOptions options) {
    cancelSolving();
    question_ = std::move(question);
    advice_ = std::move(advice);
    options_ = options;
    counts_ = std::move(counts);
    startSolving();
}

void CutAdviser::startSolving() {
    if (counts_.empty() || solving_.isBusy()) {
        return;
    }
    const std::size_t count = counts_.front();
    solving_.start(
        [question = question_, advice = advice_, count, options = options_](Progress& progress) {
            return solvedStrain(question.piece, question.own, advice, count, options, progress);
        },
        [this, count, round = round_](const Attempt<Result<StrainFigures>>& made,
                                      const Progress& progress) {
            if (round != round_ || progress.isCancelled()) {
                startSolving();
                return;
            }
            counts_.erase(counts_.begin());
            startSolving();
            if (made.answer && *made.answer) {
                emit solved(count, **made.answer);  // else the prediction is all there is to say
            }
            if (counts_.empty()) {
                emit solvedAll();
            }
        });
}

void CutAdviser::cancel() {
    cancelSolving();
    waiting_.reset();
    isDropped_ = true;
    asking_.cancel();
}

void CutAdviser::cancelSolving() {
    ++round_;
    counts_.clear();
    solving_.cancel();
}

}  // namespace toile::app
