// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

namespace toile::python {

/// Checks `threads` of a call. Throws UsageError unless it is an integer from 0 to 64.
int threadsOf(const pybind11::object& given);

/// Throws UsageError if `progress` of a call is neither None nor callable.
void checkProgress(const pybind11::object& onProgress);

}  // namespace toile::python
