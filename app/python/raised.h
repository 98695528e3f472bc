// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <exception>
#include <string>
#include <utility>

#include <pybind11/pybind11.h>

#include "app/cli/refusal.h"
#include "core/base/result.h"

namespace toile::python {

/// A refusal thrown to Python, the only exception type here. The code selects the Python class.
struct Raised : std::exception {
    explicit Raised(app::Refusal refused) : why(std::move(refused)) {}

    const char* what() const noexcept override { return why.message.c_str(); }

    app::Refusal why;
};

/// Python text; bytes of file names that are not UTF-8 are decoded as in `os.fsdecode`.
pybind11::str textOf(const std::string& text);

/// Returns the value, or throws the error or refusal.
template <class Value>
Value orRaise(app::Answer<Value> answer) {
    if (!answer) {
        throw Raised(answer.refusal());
    }
    return *std::move(answer);
}
template <class Value>
Value orRaise(Result<Value> result) {
    if (!result) {
        throw Raised(result.error());
    }
    return *std::move(result);
}

/// Binds `Problem` and translates errors to the package's exceptions.
void bindProblems(pybind11::module_& module);

}  // namespace toile::python
