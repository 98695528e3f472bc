// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/python/option_words.h"

#include <algorithm>

#include "app/python/raised.h"
#include "core/base/characters.h"
#include "core/base/error.h"

namespace toile::python {
namespace {

namespace py = pybind11;
using Words = std::vector<std::string>;

/// Placeholder argument for a mesh that was not read from a file.
constexpr const char* kNoFile = "garment";

/// Throws Raised: any text can be a keyword, and "output=a.svg" would be an option with a value.
std::string optionOf(const py::handle& keyword) {
    const bool isWord = keyword.attr("isidentifier")().cast<bool>();
    std::string key = pathOf(keyword);
    if (!isWord || key.starts_with('_')) {
        throw Raised(app::usageRefusal("\"" + shownText(key, kMaxOfPlace) + "\" is no option"));
    }
    if (key.ends_with('_')) {  // avoids Python's reserved words: as_
        key.pop_back();
    }
    std::ranges::replace(key, '_', '-');
    return "--" + key;
}

/// Converts NumPy numbers and arrays to Python's own.
py::object plain(const py::handle& value) {
    return py::hasattr(value, "tolist") ? py::object(value.attr("tolist")())
                                        : py::reinterpret_borrow<py::object>(value);
}

std::string valueOf(const py::handle& given) {
    const py::object value = plain(given);
    if (py::isinstance<py::str>(value) || py::isinstance<py::bytes>(value) ||
        py::hasattr(value, "__fspath__")) {
        return pathOf(value);
    }
    if (py::isinstance<py::sequence>(value)) {
        std::string joined;
        for (const py::handle part : value) {
            joined += joined.empty() ? "" : ",";
            joined += valueOf(part);
        }
        return joined;
    }
    return pathOf(py::str(value));
}

/// Whether a unit is given as a number, like `Garment.unit`.
bool isMillimetres(const std::string& option, const py::handle& value) {
    return (option == "--unit" || option == "--body-unit") &&
           (py::isinstance<py::float_>(value) || py::isinstance<py::int_>(value));
}

Words wordsOf(const py::kwargs& options) {
    Words words;
    for (const auto& [key, given] : options) {
        const std::string option = optionOf(key);
        const py::object value = plain(given);
        if (value.is_none() || value.ptr() == Py_False) {
            continue;
        }
        words.push_back(value.ptr() == Py_True ? option
                                               : option + "=" + valueOf(value) +
                                                     (isMillimetres(option, value) ? "mm" : ""));
    }
    return words;
}

app::Arguments parsed(const char* command, const Words& inputs, const Words& words,
                      unsigned taken) {
    return orRaise(app::typedWords(command, inputs, words, taken));
}

}  // namespace

std::string pathOf(const py::handle& path) {
    return py::module_::import("os").attr("fsencode")(path).cast<std::string>();
}

app::Arguments readingArguments(const Words& inputs, const py::kwargs& options) {
    return parsed("info", inputs, wordsOf(options), app::kReading);
}

app::Arguments flatteningArguments(int threads, const py::kwargs& options) {
    Words words = wordsOf(options);
    words.push_back("--threads=" + std::to_string(threads));
    return parsed("flatten", {kNoFile}, words, app::kFlattening | app::kThreads);
}

app::Arguments writingArguments(const Words& inputs, const Words& outputs,
                                const py::kwargs& options) {
    Words words = wordsOf(options);
    parsed("flatten", {kNoFile}, words, app::kExporting);  // must not contain files
    for (const std::string& output : outputs) {
        words.push_back("--output=" + output);
    }
    return parsed("flatten", inputs.empty() ? Words{kNoFile} : inputs, words,
                  app::kOutputFiles | app::kExporting);
}

app::Arguments provingArguments(const py::kwargs& options) {
    return parsed("prove", {kNoFile}, wordsOf(options), app::kSewing);
}

}  // namespace toile::python
