// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/project_actions.h"

#include <QDir>
#include <QFileInfo>
#include <QMenu>
#include <QWidget>
#include <algorithm>
#include <utility>

#include "app/actions/own_folders.h"
#include "app/base/text.h"
#include "app/session/workspace.h"
#include "app/settings/preferences.h"
#include "app/text/error_text.h"
#include "core/project/project_file.h"

namespace toile::app {

namespace {

constexpr int kMaxEntries = 10;

QString entryText(const QStringList& files) {
    const QFileInfo first(files.front());
    QString name = first.fileName();
    if (files.size() > 1) {
        name = RecentFiles::tr("%1 and %n more", nullptr, static_cast<int>(files.size()) - 1)
                   .arg(name);
    }
    // Escape ampersands, which would mark a mnemonic.
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
    preferences_.setRecentFiles(recent.mid(0, kMaxEntries));
}

void RecentFiles::fill(QMenu& menu) {
    connect(&menu, &QMenu::aboutToShow, this, [this, &menu] { refill(menu); });
    refill(menu);
}

void RecentFiles::refill(QMenu& menu) {
    menu.clear();
    const QList<QStringList> recent = preferences_.recentFiles();
    for (const QStringList& files : recent) {
        QAction* entry = menu.addAction(entryText(files));
        const bool there =
            std::ranges::all_of(files, [](const QString& file) { return QFileInfo::exists(file); });
        entry->setEnabled(there);
        entry->setStatusTip(there ? files.join('\n') : tr("This file no longer exists"));
        connect(entry, &QAction::triggered, this, [this, files] { emit wanted(files); });
    }
    if (recent.isEmpty()) {
        menu.addAction(tr("No recent files"))->setEnabled(false);
        return;
    }
    menu.addSeparator();
    QAction* clear = menu.addAction(tr("&Clear this list"));
    clear->setStatusTip(tr("Clear the list of recent files"));
    connect(clear, &QAction::triggered, this, [this] { preferences_.setRecentFiles({}); });
}

ProjectActions::ProjectActions(Workspace& workspace, Preferences& preferences,
                               const FileDialogs& dialogs, QWidget& window, QObject* parent)
    : QObject(parent),
      workspace_(workspace),
      preferences_(preferences),
      dialogs_(dialogs),
      window_(window),
      session_(workspace),
      recent_(preferences) {
    workspace_.askBeforeLeaving([this](std::function<void()> next) { leaveThen(std::move(next)); });
    connect(&session_, &ProjectSession::failed, this, &ProjectActions::failed);
    connect(&session_, &ProjectSession::meshesMissing, this, &ProjectActions::askForMeshes);
    connect(&session_, &ProjectSession::changedByOthers, this, &ProjectActions::askAboutOthers);
    connect(&session_, &ProjectSession::saved, this,
            [this](const QString& path) { recent_.add({path}); });
    connect(&workspace_.document(), &Document::opened, this, &ProjectActions::onOpened);
}

void ProjectActions::onOpened() {
    QStringList files;
    if (!session_.path().empty()) {
        files << textOf(session_.path());
    } else {
        for (const auto& path : workspace_.openPaths()) {
            files << QFileInfo(textOf(path)).absoluteFilePath();
        }
    }
    if (!files.isEmpty()) {
        recent_.add(files);
    }
}

void ProjectActions::open(const QString& project) {
    session_.open(pathOf(QFileInfo(project).absoluteFilePath()));
}

void ProjectActions::leaveThen(std::function<void()> next) {
    if (session_.isSaving()) {
        session_.whenSaved([this, next = std::move(next)] { leaveThen(next); });
        return;
    }
    if (!session_.isModified()) {
        next();
        return;
    }
    switch (dialogs_.askToSave(&window_, session_.title())) {
        case SaveAnswer::Save:
            // Asks again if the user edited while the file was being written.
            save([this, next = std::move(next)] { leaveThen(next); });
            break;
        case SaveAnswer::Discard:
            next();
            break;
        case SaveAnswer::Cancel:
            break;
    }
}

void ProjectActions::save(std::function<void()> then) {
    if (session_.path().empty()) {
        saveAs(std::move(then));
    } else if (workspace_.document().garment()) {
        session_.save(session_.path(), std::move(then));
    }
}

void ProjectActions::saveAs(std::function<void()> then) {
    if (!workspace_.document().garment()) {
        return;
    }
    const std::filesystem::path present = session_.path();
    const QString garment = textOf(workspace_.openPaths().front());
    const QString name = QFileInfo(present.empty() ? garment : textOf(present)).completeBaseName();
    QString path = dialogs_.saveProject(
        &window_, QString("%1/%2%3").arg(writingFolder(garment, textOf(present)), name,
                                         QString::fromUtf8(kProjectEnding)));
    if (path.isEmpty()) {
        return;
    }
    if (!isProjectFile(pathOf(path))) {
        path += QString::fromUtf8(kProjectEnding);
    }
    preferences_.setOpenFolder(QFileInfo(path).absolutePath());
    session_.save(pathOf(QFileInfo(path).absoluteFilePath()), std::move(then));
}

void ProjectActions::askAboutOthers(const std::filesystem::path& path,
                                    const std::function<void()>& then) {
    switch (dialogs_.askToOverwrite(&window_, textOf(path.filename()))) {
        case OverwriteAnswer::SaveAnyway:
            session_.save(path, then, ProjectSession::IfChanged::Overwrite);
            break;
        case OverwriteAnswer::SaveAs:
            saveAs(then);
            break;
        case OverwriteAnswer::Cancel:
            break;
    }
}

void ProjectActions::askForMeshes(const std::filesystem::path& project,
                                  const std::vector<std::filesystem::path>& missing,
                                  const ProjectSession::Retry& retry) {
    FoundMeshes found;
    QString folder = QFileInfo(textOf(project)).absolutePath();
    for (const auto& mesh : missing) {
        // Look next to a mesh that was already found: files are often moved together.
        const QString beside = folder + '/' + textOf(mesh.filename());
        QString path = !found.empty() && QFileInfo::exists(beside)
                           ? beside
                           : dialogs_.findMesh(&window_, folder, textOf(mesh.filename()));
        if (path.isEmpty()) {
            emit failed(
                errorText({ErrorCode::FileUnreadable, Subject::file(mesh.string()),
                           toile::worded("the project needs this file, but it is missing")}));
            return;
        }
        folder = QFileInfo(path).absolutePath();
        found[mesh] = pathOf(QFileInfo(path).absoluteFilePath());
    }
    retry(found);
}

}  // namespace toile::app
