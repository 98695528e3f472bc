// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/compare/comparison_model.h"

#include <QFont>
#include <algorithm>

#include "app/text/figures.h"

namespace toile {

namespace {

constexpr QChar kStar(0x2605);

}  // namespace

void ComparisonModel::show(const std::vector<MethodComparison::Entry>& entries) {
    const bool withDesigner = std::ranges::any_of(entries, [](const auto& entry) -> bool {
        return entry.made.figures.referenceRms.has_value();
    });
    std::vector<ComparisonRow> rows = comparisonRows(withDesigner);
    // Resetting would take a reader's place in the table away.
    const bool isReset = rows.size() != rows_.size() || entries.size() != entries_.size();
    if (isReset) {
        beginResetModel();
    }
    entries_ = entries;
    rows_ = std::move(rows);
    std::vector<const ComparedPiece*> pieces;
    for (const auto& entry : entries_) {
        pieces.push_back(entry.stage == MethodComparison::Stage::Done ? &entry.made : nullptr);
    }
    best_.clear();
    for (const ComparisonRow& row : rows_) {
        best_.push_back(bestOf(row, pieces));
    }
    if (isReset) {
        endResetModel();
    } else if (!entries_.empty()) {
        emit dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
        emit headerDataChanged(Qt::Horizontal, 0, columnCount() - 1);
        emit headerDataChanged(Qt::Vertical, 0, rowCount() - 1);
    }
}

bool ComparisonModel::isBest(const QModelIndex& index) const {
    return index.isValid() &&
           best_[static_cast<std::size_t>(index.row())][static_cast<std::size_t>(index.column())];
}

int ComparisonModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int ComparisonModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(entries_.size());
}

const MethodComparison::Entry& ComparisonModel::entry(const QModelIndex& index) const {
    return entries_[static_cast<std::size_t>(index.column())];
}

QVariant ComparisonModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid()) {
        return {};
    }
    const ComparisonRow& row = rows_[static_cast<std::size_t>(index.row())];
    if (role == Qt::ToolTipRole) {
        return row.tip;
    }
    if (role == Qt::TextAlignmentRole) {
        return int(Qt::AlignCenter);
    }
    const bool best = isBest(index);
    if (role == Qt::FontRole && best) {
        QFont bold;
        bold.setBold(true);
        return bold;
    }
    const bool isText =
        role == Qt::DisplayRole || role == Qt::EditRole || role == Qt::AccessibleTextRole;
    if (!isText || entry(index).stage != MethodComparison::Stage::Done) {
        return isText ? QVariant(QString()) : QVariant();
    }
    const QString text = comparisonText(row, entry(index).made);
    if (!best || role == Qt::EditRole) {
        return text;
    }
    return role == Qt::DisplayRole ? QString("%1 %2").arg(kStar).arg(text)
                                   : tr("%1, the best").arg(text);
}

QVariant ComparisonModel::headerData(int section, Qt::Orientation orientation, int role) const {
    const auto at = static_cast<std::size_t>(section);
    if (orientation == Qt::Horizontal) {
        return role == Qt::DisplayRole && at < entries_.size()
                   ? QVariant(methodName(entries_[at].method))
                   : QVariant();
    }
    if (at >= rows_.size()) {
        return {};
    }
    switch (role) {
        case Qt::DisplayRole:
            return rows_[at].title;
        case Qt::ToolTipRole:
            return rows_[at].tip;
        case Qt::TextAlignmentRole:
            return int(Qt::AlignLeft | Qt::AlignVCenter);
        default:
            return {};
    }
}

}  // namespace toile
