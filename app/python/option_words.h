// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <pybind11/pybind11.h>

#include "app/cli/arguments.h"

namespace toile::python {

/// Keyword arguments match the long options of the command line: `auto_cut=True` is `--auto-cut`,
/// `method="lscm"` is `--method lscm`, `fair=(0.5, 40)` is `--fair 0.5,40`, `as_="scan"` is `--as
/// scan`. None and False: omitted. Both use the same parser and error messages.

/// Arguments for reading. @param inputs  paths, or a placeholder for a mesh in memory
/// Throws Raised.
app::Arguments readingArguments(const std::vector<std::string>& inputs,
                                const pybind11::kwargs& options);
/// Arguments for flattening. @param threads  the option of this name
app::Arguments flatteningArguments(int threads, const pybind11::kwargs& options);
/// Arguments for writing. @param inputs  that must not be overwritten
app::Arguments writingArguments(const std::vector<std::string>& inputs,
                                const std::vector<std::string>& outputs,
                                const pybind11::kwargs& options);
/// Arguments for a proof.
app::Arguments provingArguments(const pybind11::kwargs& options);

/// The bytes of a path, which need not be UTF-8.
std::string pathOf(const pybind11::handle& path);

}  // namespace toile::python
