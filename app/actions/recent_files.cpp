// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/recent_files.h"

#include <QDir>
#include <QFileInfo>
#include <QMenu>
#include <algorithm>

#include "app/settings/preferences.h"

namespace toile {
namespace {

constexpr int kMostEntries = 10;

QString textOf(const QStringList& files) {
    const QFileInfo first(files.front());
    QString name = first.fileName();
    if (files.size() > 1) {
        name = RecentFiles::tr("%1 and %n more", nullptr, static_cast<int>(files.size()) - 1)
                   .arg(name);
    }
    // An ampersand in a name is no shortcut.
    return RecentFiles::tr("%1 in %2")
        .arg(name, QDir::toNativeSeparators(first.absolutePath()))
        .replace('&', "&&");
}

}  // namespace

RecentFiles::RecentFiles(Preferences& preferences, QObject* parent)
    : QObject(parent), preferences_(preferences) {}

void RecentFiles::add(const QStringList& files) {
    QList<QStringList> recent = preferences_.recentFiles();
    recent.removeAll(files);
    recent.prepend(files);
    preferences_.setRecentFiles(recent.mid(0, kMostEntries));
}

void RecentFiles::fill(QMenu& menu) {
    connect(&menu, &QMenu::aboutToShow, this, [this, &menu] { refill(menu); });
    refill(menu);
}

void RecentFiles::refill(QMenu& menu) {
    menu.clear();
    const QList<QStringList> recent = preferences_.recentFiles();
    for (const QStringList& files : recent) {
        QAction* entry = menu.addAction(textOf(files));
        const bool there =
            std::ranges::all_of(files, [](const QString& file) { return QFileInfo::exists(file); });
        entry->setEnabled(there);
        entry->setStatusTip(there ? files.join('\n') : tr("It is not there any more"));
        connect(entry, &QAction::triggered, this, [this, files] { emit wanted(files); });
    }
    if (recent.isEmpty()) {
        menu.addAction(tr("Nothing opened yet"))->setEnabled(false);
        return;
    }
    menu.addSeparator();
    QAction* clear = menu.addAction(tr("&Clear this list"));
    clear->setStatusTip(tr("Forget what was opened last"));
    connect(clear, &QAction::triggered, this, [this] { preferences_.setRecentFiles({}); });
}

}  // namespace toile
