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

/// The middle of the window: the welcome page, or the views with the tool palette. Errors and
/// questions that need no answer are shown above.
class WindowCentre : public QWidget {
    Q_OBJECT

public:
    /// All must outlive this object.
    WindowCentre(Workspace& workspace, const ActionRegistry& actions, ToolBox& tools,
                 Preferences& preferences, QWidget* parent);

    /// This object owns the returned parts.
    ViewArea& views() { return *views_; }
    Banner& banner() { return *banner_; }
    GarmentCard& card() { return *card_; }
    WindowBusy& busy() { return *busy_; }
    RecoveryCard& recoveryCard() { return *recoveryCard_; }
    /// True if the user has confirmed the guesses about the open garment.
    bool areGuessesKept() const { return keptGuesses_ == workspace_.openPaths(); }
    /// Asks about the guesses made for the open garment.
    void ask();
    /// Asks about unit and up axis of the open garment, guessed or not, until the user answers.
    void askAgain();
    /// Switches between the views and the welcome page.
    void showViews(bool shown);
    /// Mouse and key hints for the view that the pointer was in last.
    QString hint() const;

signals:
    /// The user chose files on the welcome page to replace the open garment.
    void filesWanted(const QStringList& files);
    /// The tool, its state or the view in use has changed.
    void hintChanged();

private:
    /// Creates the views and the tool palette, and connects both.
    QWidget* makeWork(const ActionRegistry& actions);
    void showPage();
    /// Creates a button for each tool.
    QWidget* makeToolPalette(const ActionRegistry& actions);
    void connectTools(const ActionRegistry& actions);
    /// Connects the actions for view directions and the playback bars.
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
    Workspace::Paths keptGuesses_;  ///< files whose guesses the user confirmed
    Workspace::Paths askedAgain_;   ///< files that the user wants to change guesses of
};

}  // namespace toile::app
