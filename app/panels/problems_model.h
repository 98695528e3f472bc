// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIcon>
#include <QStandardItemModel>
#include <QString>
#include <set>
#include <vector>

#include "core/check/ready_to_cut.h"

namespace toile::app {

/// Findings as a tree: those of one kind under one row that counts them, a single one by itself.
/// Rows point at findings by index.
class ProblemsModel : public QStandardItemModel {
    Q_OBJECT

public:
    enum Column { Where, Problem, Help, Advice, ColumnCount };
    /// QList<int>: the findings that a row stands for, one or all of its kind.
    static constexpr int FindingsRole = Qt::UserRole;
    /// int: the kind of a row that stands for several; invalid else.
    static constexpr int KindRole = Qt::UserRole + 1;
    /// QString: by which a row is known in the next list; the rest of a long one has none.
    static constexpr int KeyRole = Qt::UserRole + 2;
    /// int: the `Remedy` of a row's button; invalid: there is none.
    static constexpr int RemedyRole = Qt::UserRole + 3;
    /// So many rows of a kind are listed; the last one says how many more there are.
    static constexpr int kMaxRows = 200;

    explicit ProblemsModel(QObject* parent = nullptr);

    /// @param plan   what the findings are of
    /// @param shown  severities to list
    void show(const Readiness& readiness, const CutPlan& plan, const std::set<Severity>& shown);

private:
    using Row = QList<QStandardItem*>;

    void addGroup(const Readiness& readiness, const CutPlan& plan, const std::vector<int>& group);
    static Row rowOf(const Finding& finding, const CutPlan& plan, int index);
    static Row rowOfGroup(const Finding& first, const CutPlan& plan, const std::vector<int>& group);
};

/// Findings as the window tells them: in the person's language, with lengths in his unit.

/// What was found: the first letter large, no full stop.
QString problemText(const Finding& finding);
/// What to try; empty where nothing is needed.
QString problemAdvice(const Finding& finding);
/// Of several findings of a kind: "Seams that do not match".
QString problemTitle(FindingKind kind);
/// "Ready to cut", "2 faults, 1 doubt", "No faults, 3 doubts", "Not flattened yet".
QString verdictLine(const Readiness& readiness);
/// "1 fault", "3 doubts", "no notes".
QString severityCount(Severity severity, int count);

/// A red square with a cross, an amber triangle with an exclamation mark, a blue disc with an i;
/// told apart by shape and lightness too.
QIcon severityMark(Severity severity);
/// The same for the whole; a green disc with a tick where it is ready to cut.
QIcon verdictMark(const Readiness& readiness);

}  // namespace toile::app
