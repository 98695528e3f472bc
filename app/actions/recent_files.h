// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QStringList>

class QMenu;

namespace toile {

class Preferences;

/// The menu of what was opened last, the latest first. What is not there any more is greyed.
class RecentFiles : public QObject {
    Q_OBJECT

public:
    /// `preferences` must outlive this.
    explicit RecentFiles(Preferences& preferences, QObject* parent = nullptr);

    /// The files of one garment, or a project file; they come to the top.
    void add(const QStringList& files);
    /// Fills the menu, now and whenever it is about to be shown.
    void fill(QMenu& menu);

signals:
    void wanted(const QStringList& files);

private:
    void refill(QMenu& menu);

    Preferences& preferences_;
};

}  // namespace toile
