// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>
#include <vector>

#include "app/jobs/compare_job.h"

namespace toile {

/// One figure of the comparison: what it is called, and how it is written and judged.
struct ComparisonRow {
    QString title;  ///< with its unit: "Mean strain, %"
    QString tip;
    /// Less is better; none where there is nothing to tell.
    std::optional<double> (*badness)(const ComparedPiece& piece);
    /// Without the unit; asked only where there is something to tell.
    QString (*text)(const ComparedPiece& piece);
};

/// In the person's unit and language, as they are now.
/// @param withDesigner  whether the piece carries its designer's panel
std::vector<ComparisonRow> comparisonRows(bool withDesigner);

/// A dash where there is nothing to tell.
QString comparisonText(const ComparisonRow& row, const ComparedPiece& piece);

/// Per method: whether its figure is the best one, or reads like it. None is where all read alike,
/// nor where there is nothing to compare with.
/// @param pieces  null where a method is not done
std::vector<bool> bestOf(const ComparisonRow& row, const std::vector<const ComparedPiece*>& pieces);

}  // namespace toile
