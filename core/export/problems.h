// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

namespace toile {

struct SourceFile;

/// Everything there is to say about a file as a whole, each problem once: what reading, unit and
/// triangulating had to say, in this order.
Problems problemsOf(const SourceFile& file);

/// True where a mesh written from the file cannot equal it because of this problem.
bool changesOutput(ErrorCode code);

}  // namespace toile
