// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/python/raised.h"

#include <utility>

#include "app/cli/typed_words.h"

namespace toile::python {
namespace {

namespace py = pybind11;

Raised::Kind kindOf(ErrorCode code) {
    switch (code) {
        case ErrorCode::FileUnreadable:
        case ErrorCode::FileUnwritable:
        case ErrorCode::UnknownFormat:
        case ErrorCode::FormatNotBuilt:
        case ErrorCode::NotReadBack:
        case ErrorCode::MalformedFile:
        case ErrorCode::MalformedProject:
        case ErrorCode::NewerProject:
            return Raised::Kind::File;
        default:
            return Raised::Kind::Error;
    }
}

const char* className(Raised::Kind kind) {
    return kind == Raised::Kind::File    ? "FileError"
           : kind == Raised::Kind::Usage ? "UsageError"
                                         : "Error";
}

void raise(const Raised& raised) {
    const py::object type = py::module_::import("toile.errors").attr(className(raised.kind));
    const py::object made = type(textOf(raised.text), raised.code, textOf(raised.subject));
    PyErr_SetObject(type.ptr(), made.ptr());
}

}  // namespace

Raised::Raised(const Error& error)
    : kind(kindOf(error.code)),
      code(name(error.code)),
      subject(error.subject.name),
      text(sentence(error)) {}

Raised::Raised(std::string said)
    : kind(Kind::Usage), code(app::kWrongUsage), text(std::move(said)) {}

py::str textOf(const std::string& text) {
    PyObject* const made =
        PyUnicode_DecodeUTF8(text.data(), static_cast<py::ssize_t>(text.size()), "surrogateescape");
    if (made == nullptr) {
        throw py::error_already_set();
    }
    return py::reinterpret_steal<py::str>(made);
}

void bindProblems(py::module_& module) {
    py::register_exception_translator([](std::exception_ptr thrown) {
        try {
            if (thrown) {
                std::rethrow_exception(std::move(thrown));
            }
        } catch (const Raised& raised) {
            raise(raised);
        }
    });
    py::class_<Error>(module, "Problem",
                      "What went wrong, or what one should know, about one file, piece, seam or "
                      "cut. str() is a sentence.")
        .def_property_readonly(
            "code", [](const Error& error) { return std::string(name(error.code)); },
            "The name that reports have: \"several-loops\".")
        .def_property_readonly(
            "subject", [](const Error& error) { return textOf(error.subject.name); },
            "The name of what it is about; empty: everything.")
        .def_property_readonly(
            "detail", [](const Error& error) { return textOf(std::string(error.detail)); },
            "The particulars: counts, places, numbers.")
        .def_property_readonly(
            "advice", [](const Error& error) { return std::string(advice(error.code)); },
            "What can be done about it; empty where nothing is needed.")
        .def_property_readonly(
            "is_note", [](const Error& error) { return isNote(error.code); },
            "True where the work went on: nothing failed.")
        .def("__str__", [](const Error& error) { return textOf(sentence(error)); })
        .def("__repr__", [](const Error& error) {
            return textOf("<toile.Problem " + std::string(name(error.code)) + ": " +
                          sentence(error) + ">");
        });
}

}  // namespace toile::python
