// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>

class QAction;
class QWidget;

namespace toile::app {

class BusySheet;
class Workspace;

/// Shows progress in place of missing contents. While the first garment is read, this is a page
/// instead of the views. Until the first pattern exists, it is a sheet over the pattern view, with
/// a delay so that small garments do not flicker. GUI thread only.
class WindowBusy : public QObject {
    Q_OBJECT

public:
    /// All must outlive this object. @param pattern  the pattern view; null if there is none
    WindowBusy(Workspace& workspace, QAction& cancel, QWidget& centre, QWidget* pattern);

    /// Page in the centre while `isReading`.
    BusySheet& page() { return *page_; }
    /// Sheet over the pattern; null if there is no pattern view.
    BusySheet* sheet() { return sheet_; }
    /// True while the first garment is being read.
    bool isReading() const;
    /// Delay between the start of the work and the sheet; 0 shows it at once.
    void setDelay(int milliseconds) { delay_.setInterval(milliseconds); }

signals:
    /// `isReading` may have changed.
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
