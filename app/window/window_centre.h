// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "app/session/workspace.h"
#include "app/views/tool.h"

class QStackedWidget;

namespace toile::app {

class ActionRegistry;
class Banner;
class GarmentCard;
class Preferences;
class RecoveryCard;
class ToolBox;
class ViewArea;
class WindowBusy;

/// The middle of the window: a welcome, or the views with the tools beside them; above them what
/// has gone wrong, and what a person is asked without having to answer.
class WindowCentre : public QWidget {
    Q_OBJECT

public:
    /// All must outlive this.
    WindowCentre(Workspace& workspace, const ActionRegistry& actions, ToolBox& tools,
                 Preferences& preferences, QWidget* parent);

    /// Lives as long as this, as the four below do.
    ViewArea& views() { return *views_; }
    Banner& banner() { return *banner_; }
    GarmentCard& card() { return *card_; }
    WindowBusy& busy() { return *busy_; }
    RecoveryCard& recoveryCard() { return *recoveryCard_; }
    /// Whether the person has found the guesses about the open garment right.
    bool areGuessesKept() const { return keptGuesses_ == workspace_.openPaths(); }
    /// Asks about what was guessed of the open garment.
    void ask();
    /// Asks about unit and up axis of the open garment, guessed or not, until there is an answer.
    void askAgain();
    /// The views in place of the welcome, or the other way round.
    void showViews(bool shown);
    /// What mouse and keys do in the view that the pointer was in last.
    QString hint() const;

signals:
    /// To be opened in place of what is: chosen on the welcome page.
    void filesWanted(const QStringList& files);
    /// Another tool, another state of it, or another view in use.
    void hintChanged();

private:
    /// The views with the bar of tools beside them, and what is connected to both.
    QWidget* makeWork(const ActionRegistry& actions);
    void showPage();
    /// A button for each tool.
    QWidget* makeToolPalette(const ActionRegistry& actions);
    void connectTools(const ActionRegistry& actions);
    /// From which side the garment is looked at, and the way to the pattern.
    void connectLooks(const ActionRegistry& actions);

    Workspace& workspace_;
    const ActionRegistry& actions_;
    ToolBox& tools_;
    Preferences& preferences_;
    Banner* banner_;
    RecoveryCard* recoveryCard_;
    GarmentCard* card_;
    QStackedWidget* pages_;
    ViewArea* views_;
    WindowBusy* busy_;
    bool hasViews_ = false;
    Workspace::Paths keptGuesses_;  ///< files whose guesses the person has found right
    Workspace::Paths askedAgain_;   ///< files that the person wants to say something of
};

}  // namespace toile::app
