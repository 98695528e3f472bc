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

/// The project file of the open garment: which it is, whether there is anything in the garment that
/// is not in it, opening and saving. Without any widget. GUI thread only.
class ProjectSession : public QObject {
    Q_OBJECT

public:
    using Path = std::filesystem::path;
    using Retry = std::function<void(const FoundMeshes&)>;

    /// `workspace` must outlive this.
    explicit ProjectSession(Workspace& workspace, QObject* parent = nullptr);

    /// Empty where the garment has never been saved.
    const Path& path() const { return path_; }
    /// Whether there is anything to lose: a step of the history that is not saved.
    bool isModified() const;
    /// Whether the file is being written.
    bool isSaving() const { return saves_.isBusy() || saves_.hasWaiting(); }
    /// For the title: the project's name, else the garment's.
    QString title() const;

    /// Reads a project in place of what is open; that stays where it cannot be read. A recovery
    /// file opens without a name: what it says it is of may be anything.
    void open(const Path& path);
    /// Opens a recovery file of ours: as the project it was of, with unsaved changes.
    void restore(const Path& recoveryFile, const std::function<void()>& done);
    enum class IfChanged { Ask, Overwrite };

    /// Writes the garment as it is now, whatever else is running; it counts as saved from now on.
    /// Requires an open garment.
    /// @param then       called once it is written, and not where it could not be
    /// @param ifChanged  what becomes of the file where another program has changed it since it was
    ///                   read or written here: it stays, and `changedByOthers` tells
    void save(const Path& path, std::function<void()> then = {},
              IfChanged ifChanged = IfChanged::Ask);
    /// Calls it once what is being written is written, and not where that fails; at once where
    /// nothing is.
    void whenSaved(std::function<void()> then);

signals:
    /// Another file, or another answer of `isModified`.
    void changed();
    void saved(const QString& path);
    /// It was not saved: another program has changed the file.
    /// @param then  what was to be done once it was saved; may be empty
    void changedByOthers(const toile::app::ProjectSession::Path& path,
                         const std::function<void()>& then);
    /// What a person should know of a project that has been opened.
    void noticed(const QString& sentences);
    void failed(const QString& sentence);
    /// The project was not opened: these files of it are not there.
    /// @param retry  opens it with the places where they are found
    void meshesMissing(const toile::app::ProjectSession::Path& project,
                       const std::vector<std::filesystem::path>& meshes,
                       const toile::app::ProjectSession::Retry& retry);

private:
    void start(const Path& file, const FoundMeshes& found, bool restoring,
               const std::function<void()>& done);
    /// @param moved  meshes are elsewhere than the file says
    void onOpened(const Path& file, const OpenedProject& opened, bool restoring, bool moved);
    void onAnother();
    /// What was taken for saved is not.
    void onNotSaved();
    void onSaved(const Path& path, int of);

    /// What a project becomes when it is opened.
    struct OpeningAs {
        Path path;
        KnownFile known;
    };

    Workspace& workspace_;
    Path path_;
    std::shared_ptr<KnownFile> known_ = std::make_shared<KnownFile>();  ///< what path_ held last
    std::optional<OpeningAs> openingAs_;  ///< set while a project becomes the open document
    std::vector<std::function<void()>> afterSaving_;
    int opened_ = 0;   ///< garments opened so far
    int saving_ = 0;   ///< of these the one that is being written
    JobRunner saves_;  ///< apart from the others, which may take long
};

}  // namespace toile::app
