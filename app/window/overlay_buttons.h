// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QObject>
#include <array>

#include "app/actions/action_table.h"

class QAction;
class QToolBar;
class QToolButton;

namespace toile::app {

class ActionRegistry;

/// The overlays in the toolbar: a button that shows the one that is on and opens a list of all, and
/// one button for each of the two that were on last.
class OverlayButtons : public QObject {
    Q_OBJECT

public:
    /// Adds them at the bar's end. Actions and bar must outlive this.
    OverlayButtons(QToolBar& bar, const ActionRegistry& actions);

private:
    static constexpr std::size_t kLast = 2;

    void follow();
    void show();

    QList<QAction*> overlays_;
    QAction* shown_ = nullptr;
    std::array<QAction*, kLast> last_;  ///< the latest first
    QToolButton* choice_;
    std::array<QToolButton*, kLast> buttons_;
};

}  // namespace toile::app
