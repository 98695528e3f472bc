// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QObject>
#include <map>

#include "app/actions/action_registry.h"
#include "app/document/view_state.h"
#include "app/jobs/ready_checker.h"
#include "app/panels/remedies.h"
#include "app/widgets/field_keys.h"

class QAbstractItemView;
class QDockWidget;
class QMainWindow;
class QUndoView;

namespace toile::app {

class FabricPanel;
class LinesPanel;
class PiecesPanel;
class PiecePanel;
class Preferences;
class ProblemsPanel;
class ProofPanel;
class SeamsPanel;
class SymmetryPanel;
class ViewArea;
class Workspace;

/// The lists below the views and the panels beside them: makes them, lays them out, and does what
/// is asked for there. "Ready to cut?" is worked out for one of them.
class WindowDocks : public QObject {
    Q_OBJECT

public:
    /// All must outlive this.
    WindowDocks(QMainWindow& window, Workspace& workspace, const ActionRegistry& actions,
                ViewArea& views, Preferences& preferences);
    ~WindowDocks() override;

    /// Works on a thread of its own; GUI thread only, as all of this.
    ReadyChecker& checker() { return checker_; }
    /// In the order of `Panel`.
    QList<QDockWidget*> all() const;
    /// Brings a list to the front and moves the keyboard there.
    void goTo(Panel panel);
    /// Of the pieces or the seams.
    QAbstractItemView& list(Panel panel) const;
    /// Whether there is anything to show. Only the first garment brings the docks in; one that the
    /// person has closed stays closed.
    /// @return whether they came in
    bool setAvailable(bool available);

signals:
    /// A dart from the nearest edge to this place is to be proposed.
    void dartWanted(int piece, const Eigen::Vector2d& flat);
    /// A mesh to wear the sewn pattern on is to be asked for.
    void bodyWanted();
    /// The unit of the file, or the garment's height, is to be asked for.
    void unitWanted();

private:
    /// @param field  where the keyboard goes
    void add(Panel panel, const QString& title, const char* name, QWidget* content, QWidget& field,
             ActionId goThere);
    QDockWidget* dock(Panel panel) const { return places_.at(panel).dock; }
    /// Where each dock lies at first; shows none.
    void arrange();
    void show();
    /// As at the first start.
    void reset();
    void connectProof(Workspace& workspace);
    /// Shows the place of a piece that is farthest from the design once sewn.
    void showLargestGap(int piece);
    /// Selects and frames what these findings of the checker are about.
    void showFindings(const QList<int>& indices);
    /// What helps pieces that are not flat, at their places in the pattern view.
    std::map<int, Remedy> helpOfPieces() const;
    void showHelp();
    /// Does what helps, on what is selected by then.
    void help(Remedy remedy);

    QMainWindow& window_;
    Document& document_;
    const ActionRegistry& actions_;
    ViewArea& views_;
    ReadyChecker checker_;
    FieldKeys keys_;
    PiecesPanel* pieces_;
    SeamsPanel* seams_;
    ProblemsPanel* problems_;
    QUndoView* history_;
    LinesPanel* lines_;
    SymmetryPanel* symmetry_;
    ProofPanel* proof_;
    PiecePanel* piece_;
    FabricPanel* fabric_;
    struct Place {
        QDockWidget* dock;
        QWidget* field;  ///< where the keyboard goes
    };
    std::map<Panel, Place> places_;
    bool goesToFinding_ = false;
};

}  // namespace toile::app
