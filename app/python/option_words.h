// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <pybind11/pybind11.h>

#include "app/cli/arguments.h"

namespace toile::python {

/// Keyword arguments are the long options of the command line: `auto_cut=True` is `--auto-cut`,
/// `method="lscm"` is `--method lscm`, `fair=(0.5, 40)` is `--fair 0.5,40`, `as_="scan"` is
/// `--as scan`. None and False: not given. One parser reads both, and says the same of what is
/// wrong.

/// What reading is told. @param inputs  paths, or one word for a mesh that is in memory
/// Throws Raised.
app::Arguments readingArguments(const std::vector<std::string>& inputs,
                                const pybind11::kwargs& options);
/// What flattening is told. @param threads  the option of this name
app::Arguments flatteningArguments(int threads, const pybind11::kwargs& options);
/// What writing is told. @param inputs  that must not be overwritten
app::Arguments writingArguments(const std::vector<std::string>& inputs,
                                const std::vector<std::string>& outputs,
                                const pybind11::kwargs& options);
/// What a proof is told.
app::Arguments provingArguments(const pybind11::kwargs& options);

/// The bytes of a path; its name need not be UTF-8.
std::string pathOf(const pybind11::handle& path);

}  // namespace toile::python
