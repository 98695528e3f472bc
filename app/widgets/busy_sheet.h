// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

class QAction;
class QLabel;
class QProgressBar;

namespace toile::app {

/// Covers a view while its contents are computed: task, progress and a button to stop it. Fills its
/// parent if that has no layout.
class BusySheet : public QFrame {
    Q_OBJECT

public:
    /// @param cancel  action of the button; must outlive the sheet
    BusySheet(QAction& cancel, QWidget* parent);

    /// @param detail  a second line; may be empty
    void say(const QString& task, const QString& detail);
    /// Repaints at once if visible, so never call it in the middle of a change. In [0, 1].
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
