// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTableWidget>
#include <vector>

#include "app/compare/method_comparison.h"

namespace toile::app {

/// The figures of a comparison: a row per figure, a column per method, the best of a row bold and
/// with a star. As wide as it may be and as high as its rows, without scroll bars, its columns
/// under what is above them. Copies the selected rows, or all where none is selected, with their
/// titles, cells apart by tabs.
class FigureTable : public QTableWidget {
    Q_OBJECT

public:
    /// QString: what a cell says, without the star.
    static constexpr int PlainRole = Qt::UserRole;

    explicit FigureTable(QWidget* parent = nullptr);

    /// In the person's unit and language, as they are now.
    void setEntries(const std::vector<MethodComparison::Entry>& entries);
    /// The width of the rows' titles.
    void setTitleWidth(int pixels);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

private:
    void setRow(int row, const CriterionTraits& criterion,
                const std::vector<MethodComparison::Entry>& entries);
    /// What copying puts on the clipboard.
    QString copiedText() const;
};

}  // namespace toile::app
