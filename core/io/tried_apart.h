// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "core/base/progress.h"

namespace toile::io {

enum class Trial { Returns, Dies, Cancelled };

/// Runs work in a process of its own that is thrown away, to learn whether it comes back: a library
/// that ends the program on a damaged file, or never returns, does so there. What the work makes is
/// lost. Where no process can be made the work counts as returning.
/// @param work     false counts as dying; it must not ask for locks that other threads may hold
/// @param seconds  of processor time it may take; in memory six GiB beyond what the program has
/// @param progress cancelled, the process is ended at once
/// Cost: that of the work, and a fork. Any thread.
Trial triedApart(const std::function<bool()>& work, int seconds, const Progress& progress);

}  // namespace toile::io
