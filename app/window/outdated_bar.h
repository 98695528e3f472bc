// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

namespace toile::app {

class ActionRegistry;
class Workspace;
enum class PatternAge;

/// Over the pattern view, while edits wait to be flattened: says that the pattern is out of date,
/// with a button that flattens it. Export and printing say so too.
class OutdatedBar : public QWidget {
    Q_OBJECT

public:
    /// @param view  where it lies; owns it. The others must outlive this.
    OutdatedBar(Workspace& workspace, const ActionRegistry& actions, QWidget& view);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void follow(PatternAge age);
    void placeIt();

    Workspace& workspace_;
    const ActionRegistry& actions_;
    QString exportTip_, printTip_;  ///< of the actions, where nothing is wrong
};

}  // namespace toile::app
