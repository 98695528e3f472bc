// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <functional>
#include <vector>

#include "app/actions/action_registry.h"
#include "app/jobs/job_runner.h"

namespace toile {

class Workspace;

/// What the actions do to the places of the pieces on the sheet and to their grain, and which of
/// them there is something for.
class LayoutActions : public QObject {
    Q_OBJECT

public:
    /// Both must outlive this object.
    LayoutActions(ActionRegistry& actions, Workspace& workspace, QObject* parent);

signals:
    /// A wish could not be granted, and why.
    void failed(const QString& sentence);

private:
    /// Does something to the selected pieces that are flat.
    void onSelected(ActionId id, std::function<void(const std::vector<int>&)> change);
    /// The selected pieces that are flat; where none is, all.
    std::vector<int> chosen() const;
    void connectArranging();
    void connectGrain();
    void lookForBestGrain();
    void sayOutdated();
    void update();

    ActionRegistry& actions_;
    Workspace& workspace_;
    JobRunner::Ticket grain_ = 0;  ///< looks for the best grain
};

}  // namespace toile
