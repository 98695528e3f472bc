// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "app/jobs/file_jobs.h"
#include "app/jobs/job_runner.h"

namespace toile::app {

class Workspace;

/// The project file of the open garment: its path, unsaved changes, opening and saving. Without
/// widgets. GUI thread only.
class ProjectSession : public QObject {
    Q_OBJECT

public:
    using Path = std::filesystem::path;
    using Retry = std::function<void(const FoundMeshes&)>;

    /// `workspace` must outlive this.
    explicit ProjectSession(Workspace& workspace, QObject* parent = nullptr);

    /// Empty if the garment has never been saved.
    const Path& path() const { return path_; }
    /// True if a step of the history is not saved.
    bool isModified() const;
    /// True while the file is being written.
    bool isSaving() const { return saves_.isBusy() || saves_.hasWaiting(); }
    /// For titles: the name of the project, or else of the garment.
    QString title() const;

    /// Opens a project; the open garment stays if it cannot be read. A recovery file opens without
    /// a path, because the path that it names may be anything.
    void open(const Path& path);
    /// Opens a recovery file of ours: as its project, with unsaved changes.
    void restore(const Path& recoveryFile, const std::function<void()>& done);
    enum class IfChanged { Ask, Overwrite };

    /// Writes the garment as it is now, whatever else is running; it counts as saved from now on.
    /// Requires an open garment.
    /// @param then       called when it is written, unless that fails
    /// @param ifChanged  what to do if another program has changed the file since it was read or
    ///                   written here: by default keep it and emit `changedByOthers`
    void save(const Path& path, std::function<void()> then = {},
              IfChanged ifChanged = IfChanged::Ask);
    /// Calls `then` after the file is written, but not if that fails; at once if nothing is being
    /// written.
    void whenSaved(std::function<void()> then);

signals:
    /// Path or `isModified` has changed.
    void changed();
    void saved(const QString& path);
    /// Not saved: another program has changed the file.
    /// @param then  to call when it is saved; may be empty
    void changedByOthers(const toile::app::ProjectSession::Path& path,
                         const std::function<void()>& then);
    /// Notes about an opened project for the user.
    void noticed(const QString& sentences);
    void failed(const QString& sentence);
    /// The project was not opened: these of its files are missing.
    /// @param retry  opens it with the places of the files
    void meshesMissing(const toile::app::ProjectSession::Path& project,
                       const std::vector<std::filesystem::path>& meshes,
                       const toile::app::ProjectSession::Retry& retry);

private:
    void start(const Path& file, const FoundMeshes& found, bool restoring,
               const std::function<void()>& done);
    /// @param moved  meshes are not where the file says
    void onOpened(const Path& file, const OpenedProject& opened, bool restoring, bool moved);
    void onAnother();
    /// Saving has failed: the changes are unsaved again.
    void onNotSaved();
    void onSaved(const Path& path, int of);

    /// How a project is opened.
    struct OpeningAs {
        Path path;
        KnownFile known;
    };

    Workspace& workspace_;
    Path path_;
    std::shared_ptr<KnownFile> known_ = std::make_shared<KnownFile>();  ///< last content of path_
    std::optional<OpeningAs> openingAs_;  ///< set while a project is being opened
    std::vector<std::function<void()>> afterSaving_;
    int opened_ = 0;   ///< garments opened so far
    int saving_ = 0;   ///< the one that is being written
    JobRunner saves_;  ///< its own, because other jobs may take long
};

}  // namespace toile::app
