// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

namespace toile::python {

namespace py = pybind11;

/// Makes the array read-only, because its memory is shared and immutable.
inline py::array readOnly(py::array array) {
    py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
    return array;
}

/// An array view of a matrix (row by row) or vector. @param owner  keeps the memory alive
template <class Matrix>
py::array view(const Matrix& matrix, const py::handle& owner) {
    using Scalar = typename Matrix::Scalar;
    if constexpr (Matrix::IsVectorAtCompileTime) {
        return readOnly(py::array_t<Scalar>(matrix.size(), matrix.data(), owner));
    } else {
        static_assert(Matrix::IsRowMajor);
        return readOnly(py::array_t<Scalar>({matrix.rows(), matrix.cols()}, matrix.data(), owner));
    }
}

template <class Value>
py::array view(const std::vector<Value>& values, const py::handle& owner) {
    return readOnly(
        py::array_t<Value>(static_cast<py::ssize_t>(values.size()), values.data(), owner));
}

/// Pairs of numbers as an array of two columns. @param values  2 #n
inline py::array viewOfPairs(const std::vector<double>& values, const py::handle& owner) {
    const auto rows = static_cast<py::ssize_t>(values.size() / 2);
    return readOnly(py::array_t<double>({rows, py::ssize_t{2}}, values.data(), owner));
}

/// An array that takes ownership of the values.
template <class Values>
py::array owned(Values values) {
    auto kept = std::make_unique<Values>(std::move(values));
    const Values& shown = *kept;
    const py::capsule owner(kept.release(),
                            [](void* memory) { delete static_cast<Values*>(memory); });
    return view(shown, owner);
}

}  // namespace toile::python
