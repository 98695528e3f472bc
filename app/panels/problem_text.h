// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIcon>
#include <QString>

#include "core/check/ready_to_cut.h"

namespace toile::app {

/// Findings as the window tells them: in the person's language, with lengths in his unit.

/// What was found: the first letter large, no full stop.
QString problemText(const Finding& finding);
/// What to try; empty where nothing is needed.
QString problemAdvice(const Finding& finding);
/// Of several findings of a kind: "Seams that do not match".
QString problemTitle(FindingKind kind);
/// "Ready to cut", "2 faults, 1 doubt", "No faults, 3 doubts", "Not flattened yet".
QString verdictLine(const Readiness& readiness);
/// "1 fault", "3 doubts", "no notes".
QString severityCount(Severity severity, int count);

/// A red square with a cross, an amber triangle with an exclamation mark, a blue disc with an i;
/// told apart by shape and lightness too.
QIcon severityMark(Severity severity);
/// The same for the whole; a green disc with a tick where it is ready to cut.
QIcon verdictMark(const Readiness& readiness);

}  // namespace toile::app
