// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <array>
#include <set>

#include "app/panels/remedies.h"
#include "core/check/ready_to_cut.h"

class QLabel;
class QStackedWidget;
class QToolButton;
class QTreeView;

namespace toile::app {

class ProblemsModel;
class ReadyChecker;

/// Whether the garment is ready to cut: the verdict, and below it every finding, faults first. A
/// click on a finding, or Enter, goes to it. The button in its row, or Ctrl+Enter, applies its
/// remedy; the context menu lists all remedies.
class ProblemsPanel : public QWidget {
    Q_OBJECT

public:
    explicit ProblemsPanel(ReadyChecker& checker, QWidget* parent = nullptr);

    QTreeView& table() { return *table_; }
    /// Clears the selected finding. The keyboard focus stays where it is.
    void selectNothing();
    /// Number of faults and doubts, for the dock's title.
    int count() const;

signals:
    /// `count()` may have changed.
    void countChanged(int count);
    /// The user wants to see these findings of the checker's readiness; never empty.
    void wanted(const QList<int>& findings);
    /// The user wants this remedy. Emitted after `wanted` with the findings that it is for.
    void remedyWanted(toile::app::Remedy remedy);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    QWidget* makeHead();
    void makeTable();
    /// Goes to the findings of the row.
    void goTo(const QModelIndex& index);
    /// Also applies the remedy of the row's button, if it has one.
    void help(const QModelIndex& index);
    void showMenu(const QPoint& at);
    void rebuild();
    void updateHead();
    void fitColumns();
    /// What to restore after a rebuild: the current row and the expanded kinds.
    struct Outlook;
    Outlook outlook() const;
    void restore(const Outlook& before);

    static constexpr std::array kSeverities = {Severity::Fault, Severity::Doubt, Severity::Note};

    ReadyChecker& checker_;
    ProblemsModel* model_;
    QTreeView* table_;
    QLabel *mark_, *verdict_, *empty_;
    QStackedWidget* pages_;  ///< the table, or why it is empty
    std::array<QToolButton*, 3> filters_{};
    std::set<Severity> shown_{kSeverities.begin(), kSeverities.end()};
};

}  // namespace toile::app
