// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>

class QAction;
class QWidget;

namespace toile::app {

class BusySheet;
class Workspace;

/// Says what the window waits for where it waits for it: in the place of the views while the first
/// garment is read, at once; over the pattern while nothing of it is there yet, after a moment, so
/// that small garments do not flicker. GUI thread only.
class WindowBusy : public QObject {
    Q_OBJECT

public:
    /// All must outlive this. @param pattern  the view of the pattern; null where there is none
    WindowBusy(Workspace& workspace, QAction& cancel, QWidget& centre, QWidget* pattern);

    /// Stands in the centre while `isReading`.
    BusySheet& page() { return *page_; }
    /// Over the pattern; null where there is no view of it.
    BusySheet* sheet() { return sheet_; }
    /// The first garment is on its way.
    bool isReading() const;
    /// From the beginning of the work until the sheet is shown; 0: at once.
    void setDelay(int milliseconds) { delay_.setInterval(milliseconds); }

signals:
    /// `isReading` may be another now.
    void changed();

private:
    bool isPatternAwaited() const;
    void update();
    void sayTask();
    void showFraction();

    Workspace& workspace_;
    BusySheet* page_;
    BusySheet* sheet_;
    QTimer delay_;
};

}  // namespace toile::app
