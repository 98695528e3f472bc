// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pattern/piece_marks.h"

namespace toile {

/// What exported drawings say, in the person's language.
DrawingWords drawingWords();

}  // namespace toile
