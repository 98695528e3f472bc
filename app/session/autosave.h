// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QElapsedTimer>
#include <QLockFile>
#include <QObject>
#include <QTimer>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "app/document/document_state.h"
#include "app/jobs/job_runner.h"
#include "core/project/project.h"

namespace toile::app {

class Document;

/// When recovery files are written, milliseconds.
struct AutosaveTimes {
    int quiet = 20000;   ///< after the last change
    int apart = 60000;   ///< from one file to the next, at least
    int latest = 60000;  ///< after the first change, while changes go on
};

/// The times for a chosen interval in minutes; none for 0, which means never.
std::optional<AutosaveTimes> autosaveTimes(int minutes);

/// A recovery file that a crashed process has left, and the lock on it: held as long as this lives,
/// so that no other process offers the file, too.
struct RecoveryFile {
    QString path;
    QString project;  ///< path of the project, or its first mesh if it was never saved
    QDateTime time;   ///< when it was written
    std::shared_ptr<QLockFile> lock;
};

/// Keeps unsaved changes in a recovery file. A job writes it a while after a change; it is removed
/// when nothing is unsaved and at a clean exit, so that only a crash leaves one. GUI thread only.
class Autosave : public QObject {
    Q_OBJECT

public:
    /// What Autosave asks the session.
    struct Session {
        std::function<bool()> isModified;                ///< also while it is being saved
        std::function<std::filesystem::path()> project;  ///< empty if never saved
    };

    /// @param folder  created when it is needed
    /// @param times   none: nothing is written
    Autosave(const Document& document, Session session, QString folder,
             std::optional<AutosaveTimes> times, QObject* parent = nullptr);
    /// A clean exit: removes the recovery file.
    ~Autosave() override;

    /// The folder of the user's recovery files.
    static QString defaultFolder();
    /// Files that crashed processes have left, the latest first. Reads them.
    std::vector<RecoveryFile> abandoned() const;
    static void discard(const RecoveryFile& file);

    /// Sets the times; without times removes the recovery file, and writes none.
    void setTimes(std::optional<AutosaveTimes> times);
    /// Call it when the session's answers change.
    void noteChange();
    /// Call it on every change of the document: ignores changes of parts that are not saved.
    void noteDocument();
    /// Makes the file this session's own.
    void adopt(RecoveryFile file);
    /// Writes unsaved changes now.
    void writeNow();
    /// Empty if there is none.
    const QString& file() const { return file_; }

signals:
    void written(const QString& path);
    /// Unsaved changes cannot be kept, and why; tries again after a while.
    void failed(const QString& sentence);

private:
    void discard();
    bool prepare();

    const Document& document_;
    DocumentState noted_{};
    ProjectView notedView_{};
    Session session_;
    QString folder_;
    std::optional<AutosaveTimes> times_;
    QTimer timer_{this};
    QElapsedTimer sinceWriting_;  ///< invalid until there was one
    QElapsedTimer sinceChange_;   ///< the first unwritten change; invalid if there is none
    QString file_, writing_;      ///< the present one, and the last one begun
    std::shared_ptr<QLockFile> lock_;
    JobRunner jobs_;
};

}  // namespace toile::app
