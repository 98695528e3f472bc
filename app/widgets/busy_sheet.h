// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

class QAction;
class QLabel;
class QProgressBar;

namespace toile::app {

/// A calm sheet in place of what is still to come: what is being done, how far it is, and a button
/// to stop it. Fills its parent where that has no layout.
class BusySheet : public QFrame {
    Q_OBJECT

public:
    /// @param cancel  what the button does; must outlive this
    BusySheet(QAction& cancel, QWidget* parent);

    /// @param detail  a second line; may be empty
    void say(const QString& task, const QString& detail);
    /// Paints at once where it is in sight: not while something is being changed. In [0, 1].
    void setFraction(double fraction);
    QString task() const;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void tint();

    QLabel* task_;
    QLabel* detail_;
    QProgressBar* progress_;
};

}  // namespace toile::app
