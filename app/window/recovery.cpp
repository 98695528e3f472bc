// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/recovery.h"

#include <QFileInfo>
#include <QLocale>

#include "app/actions/project_actions.h"
#include "app/base/text.h"
#include "app/session/workspace.h"
#include "app/widgets/banner.h"

namespace toile::app {

Recovery::Recovery(Workspace& workspace, ProjectActions& project, RecoveryCard& card,
                   const QString& folder, std::optional<AutosaveTimes> times)
    : project_(project),
      card_(card),
      autosave_(
          workspace.document(),
          {[&session = project.session()] { return session.isModified() || session.isSaving(); },
           [&session = project.session()] { return session.path(); }},
          folder, times) {
    connect(&project.session(), &ProjectSession::changed, &autosave_, &Autosave::noteChange);
    connect(&workspace.document(), &Document::changed, &autosave_, &Autosave::noteDocument);
    connect(&card, &RecoveryCard::restoreWanted, this, &Recovery::restore);
    connect(&card, &RecoveryCard::discardWanted, this, &Recovery::discard);
    // After an attempt to restore, allow another one, whether it failed or not.
    connect(&workspace.jobs(), &JobRunner::idle, &card, [&card] { card.setEnabled(true); });
    offered_ = autosave_.abandoned();
    offerNext();
}

void Recovery::offerNext() {
    if (offered_.empty()) {
        card_.hide();
        return;
    }
    const RecoveryFile& file = offered_.front();
    const QLocale locale;
    card_.showSentence(
        tr("Toile closed before you saved your changes to %1. The last backup is from %2 at %3.")
            .arg(QFileInfo(file.project).fileName(),
                 locale.toString(file.time.date(), QLocale::ShortFormat),
                 locale.toString(file.time.time(), QLocale::ShortFormat)));
}

void Recovery::restore() {
    const RecoveryFile file = offered_.front();
    project_.leaveThen([this, file] {
        card_.setEnabled(false);  // prevent a second click while restoring
        project_.session().restore(pathOf(file.path), [this, file] {
            autosave_.adopt(file);
            // Other files are offered at the next start: one window holds one garment.
            offered_.clear();
            offerNext();
        });
    });
}

void Recovery::discard() {
    Autosave::discard(offered_.front());
    offered_.erase(offered_.begin());
    offerNext();
}

}  // namespace toile::app
