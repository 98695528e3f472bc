// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/python/raised.h"

#include <string_view>
#include <utility>

namespace toile::python {
namespace {

namespace py = pybind11;

/// Name of the class in `toile.errors`.
const char* className(std::string_view code) {
    if (code == app::kWrongUsage || code == app::kNotProved) {
        return "UsageError";
    }
    for (const ErrorCode ofFile :
         {ErrorCode::FileUnreadable, ErrorCode::FileUnwritable, ErrorCode::UnknownFormat,
          ErrorCode::FormatNotBuilt, ErrorCode::NotReadBack, ErrorCode::MalformedFile,
          ErrorCode::MalformedProject, ErrorCode::NewerProject}) {
        if (code == name(ofFile)) {
            return "FileError";
        }
    }
    return "Error";
}

void raise(const app::Refusal& why) {
    const py::object type = py::module_::import("toile.errors").attr(className(why.code));
    const py::object made =
        type(textOf(why.message), why.code, textOf(why.subject), why.isRetryable());
    PyErr_SetObject(type.ptr(), made.ptr());
}

}  // namespace

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
            raise(raised.why);
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
        .def_property_readonly(
            "again", [](const Error& error) { return app::Refusal(error).isRetryable(); },
            "Whether the machine was the reason, so that another try may help.")
        .def("__str__", [](const Error& error) { return textOf(sentence(error)); })
        .def("__repr__", [](const Error& error) {
            return textOf("<toile.Problem " + std::string(name(error.code)) + ": " +
                          sentence(error) + ">");
        });
}

}  // namespace toile::python
