// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIcon>
#include <QStandardItemModel>
#include <QString>
#include <set>
#include <vector>

#include "core/check/ready_to_cut.h"

namespace toile::app {

/// Findings as a tree. Several of one kind are grouped under a row that counts them. Rows refer to
/// findings by index.
class ProblemsModel : public QStandardItemModel {
    Q_OBJECT

public:
    enum Column { Where, Problem, Help, Advice, ColumnCount };
    /// QList<int>: the findings of a row, one or all of its kind.
    static constexpr int FindingsRole = Qt::UserRole;
    /// int: the kind of a row that groups several findings; otherwise invalid.
    static constexpr int KindRole = Qt::UserRole + 1;
    /// QString: identifies a row when the list is rebuilt. The row "and … more" has none.
    static constexpr int KeyRole = Qt::UserRole + 2;
    /// int: the `Remedy` of a row's button; invalid if it has no button.
    static constexpr int RemedyRole = Qt::UserRole + 3;
    /// Maximum number of rows per kind; one more row counts the rest.
    static constexpr int kMaxRows = 200;

    explicit ProblemsModel(QObject* parent = nullptr);

    /// @param plan   the plan that was checked
    /// @param shown  severities to list
    void show(const Readiness& readiness, const CutPlan& plan, const std::set<Severity>& shown);

private:
    using Row = QList<QStandardItem*>;

    void addGroup(const Readiness& readiness, const CutPlan& plan, const std::vector<int>& group);
    static Row rowOf(const Finding& finding, const CutPlan& plan, int index);
    static Row rowOfGroup(const Finding& first, const CutPlan& plan, const std::vector<int>& group);
};

/// Findings as text for the user: translated, with lengths in the display unit.

/// The finding itself, with a capital first letter and no full stop.
QString problemText(const Finding& finding);
/// What to try; empty if nothing is needed.
QString problemAdvice(const Finding& finding);
/// Title for several findings of a kind: "Seams that do not match".
QString problemTitle(FindingKind kind);
/// "Ready to cut", "2 faults, 1 doubt", "No faults, 3 doubts", "Not flattened yet".
QString verdictLine(const Readiness& readiness);
/// "1 fault", "3 doubts", "no notes".
QString severityCount(Severity severity, int count);

/// A red square with a cross, an amber triangle with an exclamation mark, or a blue disc with an i.
/// They differ in shape and lightness, too.
QIcon severityMark(Severity severity);
/// The same for the verdict; a green disc with a tick if the garment is ready to cut.
QIcon verdictMark(const Readiness& readiness);

}  // namespace toile::app
