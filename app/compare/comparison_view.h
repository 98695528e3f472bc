// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTableView>

namespace toile {

/// A table as wide as it may be and as high as its rows, without scroll bars, whose columns stand
/// under what is above them. Copies the selected rows, or all where none is selected, with their
/// titles, cells apart by tabs.
class ComparisonView : public QTableView {
    Q_OBJECT

public:
    explicit ComparisonView(QWidget* parent = nullptr);

    void setModel(QAbstractItemModel* model) override;
    /// The width of the rows' titles.
    void setTitleWidth(int pixels);

    /// What copying puts on the clipboard.
    QString copiedText() const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;
};

}  // namespace toile
