// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <functional>

#include "app/actions/action_registry.h"
#include "app/actions/file_dialogs.h"
#include "app/actions/project_session.h"
#include "app/actions/recent_files.h"

class QMenu;

namespace toile {

class Preferences;
class Workspace;

/// Saving, opening projects, what was opened last, and the question before changes are lost.
class ProjectActions : public QObject {
    Q_OBJECT

public:
    /// @param dialogs  asked whenever something is to be asked
    /// @param window   parent of the dialogs. All must outlive this object.
    ProjectActions(ActionRegistry& actions, Workspace& workspace, Preferences& preferences,
                   const FileDialogs& dialogs, QWidget& window, QObject* parent);

    ProjectSession& session() { return session_; }
    RecentFiles& recent() { return recent_; }
    void open(const QString& project);
    /// Goes on at once where nothing would be lost; else asks, and goes on where the person says
    /// so, after saving where that is wanted.
    void leaveThen(std::function<void()> next);

signals:
    /// What was asked for cannot be done, and why.
    void failed(const QString& sentence);

private:
    void save(std::function<void()> then);
    void saveAs(std::function<void()> then);
    void askAboutOthers(const std::filesystem::path& path, const std::function<void()>& then);
    void askForMeshes(const std::filesystem::path& project,
                      const std::vector<std::filesystem::path>& missing,
                      const ProjectSession::Retry& retry);
    void onOpened();
    void updateEnabled();

    ActionRegistry& actions_;
    Workspace& workspace_;
    Preferences& preferences_;
    const FileDialogs& dialogs_;
    QWidget& window_;
    ProjectSession session_;
    RecentFiles recent_;
};

}  // namespace toile
