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
class Preferences;
class ProblemsPanel;
class ProofPanel;
class SeamsPanel;
class SelectionPanel;
class SymmetryPanel;
class ViewArea;
class Workspace;

/// The docks below and beside the views: creates and arranges them, and handles their requests.
/// Owns the checker behind "Ready to cut?".
class WindowDocks : public QObject {
    Q_OBJECT

public:
    /// All must outlive this object.
    WindowDocks(QMainWindow& window, Workspace& workspace, const ActionRegistry& actions,
                ViewArea& views, Preferences& preferences);
    ~WindowDocks() override;

    /// It works on a thread of its own. Call it from the GUI thread only, like all members.
    ReadyChecker& checker() { return checker_; }
    /// In the order of `Panel`.
    QList<QDockWidget*> all() const;
    /// Brings a dock to the front and gives it the keyboard focus.
    void goTo(Panel panel);
    /// Table of the pieces or of the seams.
    QAbstractItemView& list(Panel panel) const;
    /// Enables or hides the docks. Only the first garment shows them; a dock that the user closed
    /// stays closed.
    /// @return  whether they were shown
    bool setAvailable(bool available);

signals:
    /// The user wants a dart from the nearest edge to this place.
    void dartWanted(int piece, const Eigen::Vector2d& flat);
    /// The user wants to choose a mesh as the body of the proof.
    void bodyWanted();
    /// The user wants to set the unit of the file or the garment's height.
    void unitWanted();

private:
    /// @param field  takes the keyboard focus
    void add(Panel panel, const QString& title, const char* name, QWidget* content, QWidget& field,
             ActionId goThere);
    QDockWidget* dock(Panel panel) const { return places_.at(panel).dock; }
    /// Puts each dock in its default place; shows none.
    void arrange();
    void show();
    /// Restores the default layout.
    void reset();
    void connectProof(Workspace& workspace);
    /// Shows where the sewn piece differs most from the design.
    void showLargestGap(int piece);
    /// Selects and frames the objects of these findings of the checker.
    void showFindings(const QList<int>& indices);
    /// Remedies of pieces that are not flat, for buttons in the pattern view.
    std::map<int, Remedy> helpOfPieces() const;
    void showHelp();
    /// Applies a remedy to the current selection.
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
    SelectionPanel* properties_;
    FabricPanel* fabric_;
    struct Place {
        QDockWidget* dock;
        QWidget* field;  ///< takes the keyboard focus
    };
    std::map<Panel, Place> places_;
    bool goesToFinding_ = false;
};

}  // namespace toile::app
