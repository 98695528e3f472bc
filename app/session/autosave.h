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
    int apart = 60000;   ///< from one to the next, at least
    int latest = 60000;  ///< after the first change, where changes never end
};

/// As a person chooses them: minutes from one writing to the next; none for 0, which is never.
std::optional<AutosaveTimes> autosaveTimes(int minutes);

/// A recovery file that a process has left behind, and the lock on it: held as long as this lives,
/// so that no other process offers it too.
struct RecoveryFile {
    QString path;
    QString project;  ///< that it is of, or its first mesh where that was never saved
    QDateTime time;   ///< of the last writing
    std::shared_ptr<QLockFile> lock;
};

/// Keeps unsaved changes in a recovery file: written by a job a while after a change, gone once
/// there is nothing unsaved and at a clean exit. What is left behind was a crash's. GUI thread
/// only.
class Autosave : public QObject {
    Q_OBJECT

public:
    /// What it has to know of the session.
    struct Session {
        std::function<bool()> isModified;                ///< also while it is being saved
        std::function<std::filesystem::path()> project;  ///< empty where never saved
    };

    /// @param folder  made when it is needed
    /// @param times   none: nothing is written
    Autosave(const Document& document, Session session, QString folder,
             std::optional<AutosaveTimes> times, QObject* parent = nullptr);
    /// A clean exit: the recovery file goes.
    ~Autosave() override;

    /// Where the person's recovery files lie.
    static QString defaultFolder();
    /// What crashed processes have left, the latest first. Reads those files.
    std::vector<RecoveryFile> abandoned() const;
    static void discard(const RecoveryFile& file);

    /// From now on; without times the recovery file goes, and none is written.
    void setTimes(std::optional<AutosaveTimes> times);
    /// To be called when the session's answers are others.
    void noteChange();
    /// To be called on every change of the document: notes it if what is saved differs from what
    /// was noted last.
    void noteDocument();
    /// The file is this session's from now on.
    void adopt(RecoveryFile file);
    /// Writes now what there is to write.
    void writeNow();
    /// Empty where there is none.
    const QString& file() const { return file_; }

signals:
    void written(const QString& path);
    /// Unsaved changes cannot be kept, and why; it is tried again after a while.
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
    QElapsedTimer sinceChange_;   ///< the first that is not written; invalid where there is none
    QString file_, writing_;      ///< the present one, and the last that was begun
    std::shared_ptr<QLockFile> lock_;
    JobRunner jobs_;
};

}  // namespace toile::app
