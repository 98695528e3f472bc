// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

namespace toile::python {

/// `load` and `garment_of_arrays`.
void bindLoading(pybind11::module_& module);

}  // namespace toile::python
