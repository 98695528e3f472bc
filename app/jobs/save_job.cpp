// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/save_job.h"

#include <QCoreApplication>
#include <utility>

#include "app/base/path_text.h"
#include "app/document/document.h"
#include "app/document/project_state.h"
#include "core/project/project_file.h"

namespace toile {

SaveJob::SaveJob(const Document& document, Target target, Done done)
    : state_(document.state()),
      view_(document.view()),
      target_(std::move(target)),
      done_(std::move(done)) {
    Q_ASSERT(state_.garment);
}

QString SaveJob::title() const {
    return QCoreApplication::translate("SaveJob", "Saving %1").arg(textOf(target_.path.filename()));
}

Result<void> SaveJob::process(Progress&) {
    // At the last moment: another program may be at it just now.
    KnownFile* known = target_.known.get();
    if (known && known->path == target_.path && !target_.overwrite && wasChangedByOthers(*known)) {
        outcome_ = Outcome::ChangedByOthers;
        return {};
    }
    Project project = projectOf(state_, view_);
    project.recoveryOf = target_.recoveryOf;
    const auto written = writeProject(target_.path, project);
    if (!written) {
        return written.error();
    }
    if (known) {
        *known = {target_.path, *written};
    }
    return {};
}

void SaveJob::finalize() {
    done_(outcome_);
}

}  // namespace toile
