// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/autosave.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QStandardPaths>
#include <QUuid>
#include <algorithm>
#include <utility>

#include "app/base/text.h"
#include "app/document/document.h"
#include "app/jobs/file_jobs.h"
#include "core/project/project_file.h"

namespace toile::app {
namespace {

constexpr auto kLockEnding = ".lock";
constexpr int kMinute = 60'000;  ///< milliseconds

/// A lock that becomes stale only when its process ends, not by age.
std::shared_ptr<QLockFile> lockOf(const QString& file) {
    auto lock = std::make_shared<QLockFile>(file + kLockEnding);
    lock->setStaleLockTime(0);
    return lock->tryLock(0) ? lock : nullptr;
}

}  // namespace

Autosave::Autosave(const Document& document, Session session, QString folder,
                   std::optional<AutosaveTimes> times, QObject* parent)
    : QObject(parent),
      document_(document),
      session_(std::move(session)),
      folder_(std::move(folder)),
      times_(times) {
    timer_.setSingleShot(true);
    connect(&timer_, &QTimer::timeout, this, &Autosave::writeNow);
    connect(&jobs_, &JobRunner::failed, this, [this](const QString&, const QString& sentence) {
        if (times_) {
            timer_.start(times_->apart);
        }
        emit failed(sentence);
    });
}

Autosave::~Autosave() {
    jobs_.shutdown();  // waits for a file being written, which is removed, too
    if (!writing_.isEmpty()) {
        QFile::remove(writing_);
    }
    discard();
}

QString Autosave::defaultFolder() {
    return QDir(QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation))
        .filePath("recovery");
}

std::vector<RecoveryFile> Autosave::abandoned() const {
    std::vector<RecoveryFile> found;
    const QString pattern = QString("*%1").arg(QString::fromUtf8(kProjectEnding));
    for (const QFileInfo& info : QDir(folder_).entryInfoList({pattern}, QDir::Files, QDir::Time)) {
        auto lock = info.absoluteFilePath() == file_ ? nullptr : lockOf(info.absoluteFilePath());
        if (!lock) {
            continue;  // its process is alive
        }
        const auto read = readProject(pathOf(info.absoluteFilePath()));
        if (!read) {
            continue;  // unreadable, and not ours to remove
        }
        const auto of = read->project.recoveryOf.value_or(std::filesystem::path());
        found.push_back({info.absoluteFilePath(),
                         textOf(of.empty() ? read->project.files.front().path : of),
                         info.lastModified(), std::move(lock)});
    }
    return found;
}

void Autosave::discard(const RecoveryFile& file) {
    QFile::remove(file.path);
    file.lock->unlock();
}

std::optional<AutosaveTimes> autosaveTimes(int minutes) {
    if (minutes <= 0) {
        return std::nullopt;
    }
    AutosaveTimes times;
    times.apart = minutes * kMinute;
    return times;
}

void Autosave::setTimes(std::optional<AutosaveTimes> times) {
    times_ = times;
    noteChange();
}

void Autosave::noteChange() {
    if (!times_ || !session_.isModified()) {
        timer_.stop();
        sinceChange_.invalidate();
        discard();
        return;
    }
    if (!sinceChange_.isValid()) {
        sinceChange_.start();
    }
    qint64 wait = std::min<qint64>(times_->quiet, times_->latest - sinceChange_.elapsed());
    if (sinceWriting_.isValid()) {
        wait = std::max(wait, times_->apart - sinceWriting_.elapsed());
    }
    timer_.start(static_cast<int>(std::max<qint64>(wait, 0)));
}

void Autosave::noteDocument() {
    ProjectView view = savedView(document_.view());
    if (!(document_.state() == noted_) || !(view == notedView_)) {
        noted_ = document_.state();
        notedView_ = std::move(view);
        noteChange();
    }
}

void Autosave::writeNow() {
    timer_.stop();
    if (!times_ || !session_.isModified() || !document_.garment()) {
        return;
    }
    if (jobs_.isBusy()) {
        timer_.start(times_->quiet);
        return;
    }
    if (!prepare()) {
        return;  // no folder to write to
    }
    sinceWriting_.start();
    sinceChange_.invalidate();
    writing_ = file_;
    SaveTarget target{.path = pathOf(file_), .recoveryOf = session_.project()};
    jobs_.start(saveJob(document_, std::move(target), [this, file = file_](SaveOutcome) {
        if (file != file_) {
            QFile::remove(file);  // saved meanwhile
        } else {
            emit written(file);
        }
    }));
}

bool Autosave::prepare() {
    if (!file_.isEmpty()) {
        return true;
    }
    if (!QDir().mkpath(folder_)) {
        return false;
    }
    const QString name = QUuid::createUuid().toString(QUuid::WithoutBraces);
    const QString file = QDir(folder_).absoluteFilePath(name + QString::fromUtf8(kProjectEnding));
    lock_ = lockOf(file);
    if (lock_) {
        file_ = file;
    }
    return lock_ != nullptr;
}

void Autosave::adopt(RecoveryFile file) {
    discard();
    file_ = std::move(file.path);
    lock_ = std::move(file.lock);
}

void Autosave::discard() {
    if (file_.isEmpty()) {
        return;
    }
    QFile::remove(std::exchange(file_, {}));
    lock_.reset();  // unlocks
}

}  // namespace toile::app
