// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIcon>
#include <QString>
#include <functional>

namespace toile {

/// One line of the command palette.
struct Command {
    QString text;
    QString place{};  ///< where it is found otherwise: "View ▸ Show"
    QString tip{};
    QString otherwise{};  ///< what else it is called: it is found by these words too
    QString keys{};
    QIcon icon{};
    bool enabled = true;
    bool listedUnasked = true;    ///< also while nothing is typed
    std::function<void()> run{};  ///< required
};

}  // namespace toile
