// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QStringList>
#include <functional>

#include "app/actions/file_dialogs.h"
#include "app/session/project_session.h"

class QMenu;

namespace toile::app {

class Preferences;
class Workspace;

/// Menu of recent files, latest first. Missing files are disabled.
class RecentFiles : public QObject {
    Q_OBJECT

public:
    /// `preferences` must outlive this object.
    explicit RecentFiles(Preferences& preferences, QObject* parent = nullptr);

    /// Moves the files of one garment, or a project file, to the top.
    void add(const QStringList& files);
    /// Fills the menu, now and before it is shown.
    void fill(QMenu& menu);

signals:
    void wanted(const QStringList& files);

private:
    void refill(QMenu& menu);

    Preferences& preferences_;
};

/// Saves and opens projects, keeps recent files, and asks before changes are lost.
class ProjectActions : public QObject {
    Q_OBJECT

public:
    /// @param dialogs  used for every question
    /// @param window   parent of the dialogs. All must outlive this object.
    ProjectActions(Workspace& workspace, Preferences& preferences, const FileDialogs& dialogs,
                   QWidget& window, QObject* parent);

    ProjectSession& session() { return session_; }
    RecentFiles& recent() { return recent_; }
    void open(const QString& project);
    /// Saves to the project's file, or asks for one if it has none yet.
    /// @param then  called after saving
    void save(std::function<void()> then = {});
    /// Asks where to save.
    void saveAs(std::function<void()> then = {});
    /// Calls `next` at once if nothing would be lost. Otherwise asks first; the user can save,
    /// discard or cancel.
    void leaveThen(std::function<void()> next);

signals:
    /// A request failed; `sentence` explains why.
    void failed(const QString& sentence);

private:
    void askAboutOthers(const std::filesystem::path& path, const std::function<void()>& then);
    void askForMeshes(const std::filesystem::path& project,
                      const std::vector<std::filesystem::path>& missing,
                      const ProjectSession::Retry& retry);
    void onOpened();

    Workspace& workspace_;
    Preferences& preferences_;
    const FileDialogs& dialogs_;
    QWidget& window_;
    ProjectSession session_;
    RecentFiles recent_;
};

}  // namespace toile::app
