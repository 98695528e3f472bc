// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

/// What a pen draws from where it is lowered to where it is raised.
struct PltLine {
    int pen = 0;
    Points2 points = Points2(0, 2);  ///< mm, y up; two or more
    bool closed = false;             ///< ends where it began: the first is not repeated
};

/// The lines of an HPGL file, 40 units to the millimetre, in the order of the file: IN, PA, PR, PU,
/// PD and SP, in either case, with or without semicolons. Labels and what else there is are passed
/// over; arcs and circles too.
/// Errors: MalformedFile (no instruction to draw; a scale of its own, SC). Cost: linear. Pure.
Result<std::vector<PltLine>> readPlt(std::string_view bytes);

}  // namespace toile
