// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "app/actions/action_registry.h"

namespace toile {

class Workspace;

/// What the actions do that say how the garment's files are read, divided and cut. Keeps them
/// checked as the workspace's `loading` is.
class ReadingActions : public QObject {
    Q_OBJECT

public:
    /// Both must outlive this object.
    ReadingActions(ActionRegistry& actions, Workspace& workspace, QObject* parent);

private:
    void connectActions();
    void updateChecked();
    void updateEnabled();

    ActionRegistry& actions_;
    Workspace& workspace_;
};

}  // namespace toile
