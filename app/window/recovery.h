// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <optional>
#include <vector>

#include "app/session/autosave.h"

namespace toile::app {

class ProjectActions;
class RecoveryCard;
class Workspace;

/// Writes a recovery file of the session's unsaved changes, and offers the files of crashed
/// processes on the card.
class Recovery : public QObject {
    Q_OBJECT

public:
    /// All must outlive this object. @param folder  of the recovery files
    /// @param times   none: no new files are written
    Recovery(Workspace& workspace, ProjectActions& project, RecoveryCard& card,
             const QString& folder, std::optional<AutosaveTimes> times);

    Autosave& autosave() { return autosave_; }

private:
    void offerNext();
    void restore();
    void discard();

    ProjectActions& project_;
    RecoveryCard& card_;
    Autosave autosave_;
    std::vector<RecoveryFile> offered_;  ///< the first one is on the card
};

}  // namespace toile::app
