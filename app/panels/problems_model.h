// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStandardItemModel>
#include <set>
#include <vector>

#include "core/check/ready_to_cut.h"

namespace toile::app {

/// Findings as a tree: those of one kind under one row that counts them, a single one by itself.
/// Rows point at findings by index.
class ProblemsModel : public QStandardItemModel {
    Q_OBJECT

public:
    enum Column { Where, Problem, Advice, ColumnCount };
    /// QList<int>: the findings that a row stands for, one or all of its kind.
    static constexpr int FindingsRole = Qt::UserRole;
    /// int: the kind of a row that stands for several; invalid else.
    static constexpr int KindRole = Qt::UserRole + 1;
    /// QString: by which a row is known in the next list; the rest of a long one has none.
    static constexpr int KeyRole = Qt::UserRole + 2;
    /// So many rows of a kind are listed; the last one says how many more there are.
    static constexpr int kMostRows = 200;

    explicit ProblemsModel(QObject* parent = nullptr);

    /// @param shown  severities to list
    void show(const Readiness& readiness, const std::set<Severity>& shown);

private:
    using Row = QList<QStandardItem*>;

    void addGroup(const Readiness& readiness, const std::vector<int>& group);
    static Row rowOf(const Finding& finding, int index);
    static Row rowOfGroup(const Finding& first, const std::vector<int>& group);
};

}  // namespace toile::app
