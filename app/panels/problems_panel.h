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

/// Whether the garment is ready to cut, and what stands against it: the verdict, and every finding
/// under it, the faults first. A click on one, or Enter, goes there; the button in its row, or
/// Ctrl+Enter, does what helps; the context menu has all that may help.
class ProblemsPanel : public QWidget {
    Q_OBJECT

public:
    explicit ProblemsPanel(ReadyChecker& checker, QWidget* parent = nullptr);

    QTreeView& table() { return *table_; }
    /// What is selected is no finding any more. The keyboard stays where it is.
    void selectNothing();
    /// Faults and doubts, for the dock's title.
    int count() const;

signals:
    /// `count` may be another.
    void countChanged(int count);
    /// These findings of the checker's readiness are to be shown; never empty.
    void wanted(const QList<int>& findings);
    /// This is to be done about them, after they were shown.
    void remedyWanted(toile::app::Remedy remedy);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    QWidget* makeHead();
    void makeTable();
    /// Of the row: goes there.
    void goTo(const QModelIndex& index);
    /// And does what its button says, if it has one.
    void help(const QModelIndex& index);
    void showMenu(const QPoint& at);
    void rebuild();
    void updateHead();
    void fitColumns();
    /// What a person looks at: the row that is current, and which kinds are open.
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
