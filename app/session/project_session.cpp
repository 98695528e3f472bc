// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/project_session.h"

#include <utility>

#include "app/base/text.h"
#include "app/jobs/file_jobs.h"
#include "app/session/workspace.h"
#include "app/text/error_text.h"

namespace toile::app {
namespace {

constexpr int kMaxSentences = 4;  ///< shown when a project is opened

}  // namespace

ProjectSession::ProjectSession(Workspace& workspace, QObject* parent)
    : QObject(parent), workspace_(workspace) {
    connect(&workspace.document(), &Document::opened, this, &ProjectSession::onAnother);
    connect(&workspace.document().history(), &QUndoStack::cleanChanged, this,
            &ProjectSession::changed);
    connect(&saves_, &JobRunner::failed, this, [this](const QString&, const QString& sentence) {
        afterSaving_.clear();
        onNotSaved();
        emit failed(sentence);
    });
}

bool ProjectSession::isModified() const {
    return workspace_.document().garment() && !workspace_.document().history().isClean();
}

void ProjectSession::onNotSaved() {
    if (saving_ == opened_) {
        workspace_.document().history().resetClean();  // it was not saved
    }
}

QString ProjectSession::title() const {
    return path_.empty() ? workspace_.document().title() : textOf(path_.filename());
}

void ProjectSession::open(const Path& path) {
    start(path, {}, false, {});
}

void ProjectSession::restore(const Path& recoveryFile, const std::function<void()>& done) {
    start(recoveryFile, {}, true, done);
}

void ProjectSession::start(const Path& file, const FoundMeshes& found, bool restoring,
                           const std::function<void()>& done) {
    const bool moved = !found.empty();
    workspace_.openBy(projectJob(
        file, found,
        [this, file, restoring, moved, done](OpenedProject opened) {
            workspace_.arrived([this, file, restoring, moved, done, opened = std::move(opened)] {
                onOpened(file, opened, restoring, moved);
                if (done) {
                    done();
                }
            });
        },
        [this, file, restoring, done](const std::vector<Path>& missing) {
            workspace_.notOpened();
            emit meshesMissing(file, missing, [=, this](const FoundMeshes& foundNow) {
                start(file, foundNow, restoring, done);
            });
        }));
}

void ProjectSession::onOpened(const Path& file, const OpenedProject& opened, bool restoring,
                              bool moved) {
    Document& document = workspace_.document();
    const ViewState view = viewOf(
        opened.project.view, document.garment() ? viewOfNext(document.view()) : document.view());
    const auto& recoveryOf = opened.project.recoveryOf;
    // Saving must not write to a path that another file names.
    openingAs_ = restoring    ? OpeningAs{recoveryOf.value_or(file), opened.known}
                 : recoveryOf ? OpeningAs{}
                              : OpeningAs{file, opened.known};
    DocumentState state = stateOf(opened.project, opened.derived.inputs, *opened.derived.garment);
    state.reference = opened.reference;
    document.open(std::move(state), opened.derived);
    document.setView(view);
    if (restoring || moved || recoveryOf) {
        document.history().resetClean();
    }
    QStringList sentences;
    for (const Error& note : opened.notes) {
        sentences << errorText(note);
    }
    if (const auto more = static_cast<int>(sentences.size()) - kMaxSentences; more > 0) {
        sentences = sentences.mid(0, kMaxSentences) << tr("And %n more like this.", nullptr, more);
    }
    if (!sentences.isEmpty()) {
        emit noticed(sentences.join('\n'));
    }
}

void ProjectSession::onAnother() {
    ++opened_;
    OpeningAs as = std::exchange(openingAs_, std::nullopt).value_or(OpeningAs{});
    path_ = std::move(as.path);
    known_ = std::make_shared<KnownFile>(std::move(as.known));
    emit changed();
}

void ProjectSession::save(const Path& path, std::function<void()> then, IfChanged ifChanged) {
    Document& document = workspace_.document();
    Q_ASSERT(document.garment());
    saving_ = opened_;
    saves_.start(saveJob(
        document,
        SaveTarget{.path = path, .known = known_, .overwrite = ifChanged == IfChanged::Overwrite},
        [this, path, then = std::move(then), of = opened_](SaveOutcome outcome) {
            if (outcome == SaveOutcome::Written) {
                onSaved(path, of);
                if (then) {
                    then();
                }
                return;
            }
            afterSaving_.clear();
            onNotSaved();
            if (of == opened_) {
                emit changedByOthers(path, then);
            } else {  // that garment is closed
                emit failed(errorText({ErrorCode::FileUnwritable, Subject::file(path.string()),
                                       toile::worded("another program has changed it")}));
            }
        }));
    // Edits made while the file is written are not in it.
    document.history().setClean();
}

void ProjectSession::onSaved(const Path& path, int of) {
    if (of == opened_) {  // else another garment was opened meanwhile
        path_ = path;
        emit changed();
    }
    emit saved(textOf(path));
    for (const auto& next : std::exchange(afterSaving_, {})) {
        next();
    }
}

void ProjectSession::whenSaved(std::function<void()> then) {
    if (isSaving()) {
        afterSaving_.push_back(std::move(then));
    } else {
        then();
    }
}

}  // namespace toile::app
