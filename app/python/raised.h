// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <exception>
#include <string>

#include <pybind11/pybind11.h>

#include "core/base/error.h"
#include "core/base/result.h"

namespace toile::python {

/// An error on its way to Python: the one thing here that is thrown.
struct Raised : std::exception {
    enum class Kind { Error, File, Usage };

    explicit Raised(const Error& error);
    /// Of a call that nobody can make sense of.
    explicit Raised(std::string said);

    const char* what() const noexcept override { return text.c_str(); }

    Kind kind;
    std::string code, subject, text;
};

/// Text for Python: bytes of file names that are not UTF-8 as `os.fsdecode` has them.
pybind11::str textOf(const std::string& text);

/// The value, or the error thrown.
template <class Value>
Value orRaise(Result<Value> result) {
    if (!result) {
        throw Raised(result.error());
    }
    return *std::move(result);
}

/// `Problem`, and how errors become exceptions of the package.
void bindProblems(pybind11::module_& module);

}  // namespace toile::python
