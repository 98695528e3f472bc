// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>

#include "app/compare/comparison_rows.h"
#include "app/compare/method_comparison.h"

namespace toile {

/// The table of the comparison: a row per figure, a column per method. The best of a row is bold
/// and has a star; Qt::EditRole is the text without it.
class ComparisonModel : public QAbstractTableModel {
    Q_OBJECT

public:
    explicit ComparisonModel(QObject* parent = nullptr) : QAbstractTableModel(parent) {}

    void show(const std::vector<MethodComparison::Entry>& entries);
    bool isBest(const QModelIndex& index) const;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    const MethodComparison::Entry& entry(const QModelIndex& index) const;

    std::vector<MethodComparison::Entry> entries_;
    std::vector<ComparisonRow> rows_;
    std::vector<std::vector<bool>> best_;  ///< per row, per method
};

}  // namespace toile
