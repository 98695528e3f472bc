// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace toile {

class ActionRegistry;
class Workspace;

/// Connects the actions that say how the garment's files are read, divided and cut, and keeps them
/// checked as the workspace's `loading` is, for as long as both live.
void connectReading(ActionRegistry& actions, Workspace& workspace);

}  // namespace toile
