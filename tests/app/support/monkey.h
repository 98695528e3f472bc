// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointer>
#include <QStringList>
#include <QTimer>
#include <QWidget>
#include <deque>
#include <functional>
#include <vector>

#include "app/actions/action_registry.h"
#include "core/cut/user_cuts.h"
#include "tests/core/support/generator.h"

class QAction;

namespace toile::app {
class Document;
class MainWindow;
class SceneView;
}  // namespace toile::app

namespace toile::test {

using namespace app;

/// A path through points anywhere on some piece, mm; often one that cannot be cut.
UserCut randomCut(const Document& document, Generator& random);

/// Uses a window and its garment at random: mouse and keys in the views, actions, numbers in the
/// panels, and requests to the workspace, even during a drag or a job. The same seed gives the same
/// attempts; their effect depends on how far jobs are.
///
/// It never opens another garment and never quits, because those clear the history.
class Monkey {
public:
    /// @param folder  where it may write
    Monkey(MainWindow& window, Generator& random, QString folder);
    ~Monkey();

    /// Does one random thing.
    void act();
    /// The last things it did, latest last.
    QStringList trace() const;
    int actionsDone() const { return done_; }
    /// How an exported file differed from the pattern that it was made from; empty if none did.
    const QString& misread() const { return misread_; }

private:
    struct Habit {
        int weight;
        void (Monkey::*does)();
    };

    void note(const QString& what);
    SceneView& someView();
    QPoint placeIn(const QWidget& widget);
    Qt::KeyboardModifiers someModifiers();
    Qt::MouseButton someButton();
    /// A random visible widget of this type. It may be hidden or deleted soon after.
    template <class Widget>
    Widget* someVisible() {
        const auto is = [](QWidget* widget) { return qobject_cast<Widget*>(widget) != nullptr; };
        return qobject_cast<Widget*>(someVisible(is));
    }
    QWidget* someVisible(const std::function<bool(QWidget*)>& isMeant);

    void triggerAction();
    void flattenOtherwise();
    void click();
    void doubleClick();
    void drag();
    void drawWithTool();
    void hover();
    void wheel();
    void pressKey();
    void typeShortcut();
    void typeNumber();
    void clickInPanel();
    void clickInTable();
    void editInTable();
    void clickInHistory();
    void undoOrRedo();
    void searchCommand();
    void slideMorph();
    void select();
    void cutSomewhere();
    void takeOut();
    void stateEase();
    void decideOnLines();
    void decideOnSymmetry();
    void layOut();
    void openMenu();
    /// Chooses an entry of the open menu, if any, or of its submenus.
    void chooseInMenu();
    bool isLeftAlone(const QAction& action) const;
    void typeNameOfPiece();
    void hideOrLeaveOut();
    void leaveOutSmall();
    void pressRemedy();
    void exportPattern();
    void choosePreference();
    void touchFrame();
    void cancel();
    void pause();
    void settle();
    /// Does something else in the middle of a drag.
    void interrupt();
    void answerDialogs();
    void watchExports();

    MainWindow& window_;
    Generator& random_;
    QString folder_;
    QTimer closer_;  ///< closes dialogs that wait for the user
    std::vector<Habit> habits_;
    std::vector<ActionId> ids_;
    std::deque<QString> trace_;
    QString misread_;
    int done_ = 0, depth_ = 0;
};

}  // namespace toile::test
