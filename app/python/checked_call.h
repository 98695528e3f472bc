// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

namespace toile::python {

/// `threads` of a call. Throws UsageError where it is no whole number from 0 to 64.
int threadsOf(const pybind11::object& given);

/// Throws UsageError where `progress` of a call is neither None nor to be called.
void checkProgress(const pybind11::object& onProgress);

}  // namespace toile::python
