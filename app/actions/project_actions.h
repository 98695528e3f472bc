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

/// Saving, opening projects, what was opened last, and the question before changes are lost.
class ProjectActions : public QObject {
    Q_OBJECT

public:
    /// @param dialogs  asked whenever something is to be asked
    /// @param window   parent of the dialogs. All must outlive this object.
    ProjectActions(Workspace& workspace, Preferences& preferences, const FileDialogs& dialogs,
                   QWidget& window, QObject* parent);

    ProjectSession& session() { return session_; }
    RecentFiles& recent() { return recent_; }
    void open(const QString& project);
    /// In its file, or where the person says when it has none yet.
    /// @param then  once it is saved
    void save(std::function<void()> then = {});
    /// Where the person says.
    void saveAs(std::function<void()> then = {});
    /// Goes on at once where nothing would be lost; else asks, and goes on where the person says
    /// so, after saving where that is wanted.
    void leaveThen(std::function<void()> next);

signals:
    /// What was asked for cannot be done, and why.
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
