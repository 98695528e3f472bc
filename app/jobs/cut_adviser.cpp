// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/cut_adviser.h"

#include "app/text/error_text.h"
#include "core/tailor/mesh_lines.h"
#include "core/toile/pipeline.h"

namespace toile::app {

CutAdviser::CutAdviser()
    : asking_(
          [](const AdviceQuestion& asked, Progress& progress) {
              AdviceOptions options = asked.options;
              options.borders = fileBorders(*asked.piece, *asked.file->soup);
              return adviseCuts(asked.piece, asked.own, options, progress);
          },
          [this](const Attempt<CutAdvice>& made, const AdviceQuestion&, bool) {
              if (made.answer) {
                  emit advised(*made.answer);
              } else {
                  emit failed(faultText(made.fault));
              }
          }),
      solving_(
          [](const Trial& trial, Progress& progress) {
              const auto& [question, advice] = *trial.cuts;
              return solvedStrain(question.piece, question.own, advice, trial.count, trial.options,
                                  progress);
          },
          [this](const Attempt<Result<StrainFigures>>& made, const Trial& trial, bool) {
              counts_.erase(counts_.begin());
              solveNext();
              if (made.answer && *made.answer) {
                  emit solved(trial.count, **made.answer);  // else the prediction stays
              }
              if (counts_.empty()) {
                  emit solvedAll();
              }
          }) {}

void CutAdviser::ask(AdviceQuestion question) {
    cancel();
    asking_.ask(std::move(question));
}

void CutAdviser::solve(AdviceQuestion question, CutAdvice advice, std::vector<std::size_t> counts,
                       FlattenOptions options) {
    cancelSolving();
    trial_ = {std::make_shared<const std::pair<AdviceQuestion, CutAdvice>>(std::move(question),
                                                                           std::move(advice)),
              options};
    counts_ = std::move(counts);
    solveNext();
}

void CutAdviser::solveNext() {
    if (!counts_.empty()) {
        trial_.count = counts_.front();
        solving_.ask(trial_);
    }
}

void CutAdviser::cancel() {
    cancelSolving();
    asking_.forget();
}

void CutAdviser::cancelSolving() {
    counts_.clear();
    solving_.forget();
}

}  // namespace toile::app
