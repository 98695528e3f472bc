// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <exception>
#include <string>
#include <utility>

#include <pybind11/pybind11.h>

#include "app/cli/refusal.h"
#include "core/base/result.h"

namespace toile::python {

/// A refusal on its way to Python: the one thing here that is thrown. Its class follows from its
/// code.
struct Raised : std::exception {
    explicit Raised(app::Refusal refused) : why(std::move(refused)) {}

    const char* what() const noexcept override { return why.message.c_str(); }

    app::Refusal why;
};

/// Text for Python: bytes of file names that are not UTF-8 as `os.fsdecode` has them.
pybind11::str textOf(const std::string& text);

/// The value, or the error or refusal thrown.
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

/// `Problem`, and how errors become exceptions of the package.
void bindProblems(pybind11::module_& module);

}  // namespace toile::python
