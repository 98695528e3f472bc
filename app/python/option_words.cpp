// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/python/option_words.h"

#include <algorithm>
#include <initializer_list>
#include <string_view>

#include "app/cli/typed_words.h"
#include "app/python/raised.h"
#include "core/base/characters.h"
#include "core/base/error.h"
#include "core/export/format_options.h"

namespace toile::python {
namespace {

namespace py = pybind11;
using Words = std::vector<std::string>;

/// A mesh that is not read from a file stands for one.
constexpr const char* kNoFile = "garment";

/// Throws Raised: a keyword may be any text, and "output=a.svg" would be an option with a value.
std::string optionOf(const py::handle& keyword) {
    const bool isWord = keyword.attr("isidentifier")().cast<bool>();
    std::string key = pathOf(keyword);
    if (!isWord || key.starts_with('_')) {
        throw Raised("\"" + shownText(key, kMaxOfPlace) + "\" is no option");
    }
    if (key.ends_with('_')) {  // of what Python keeps for itself: as_
        key.pop_back();
    }
    std::ranges::replace(key, '_', '-');
    return "--" + key;
}

/// Numbers and arrays of numpy as Python's own.
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

Words wordsOf(const py::kwargs& options) {
    Words words;
    for (const auto& [key, given] : options) {
        const std::string option = optionOf(key);
        const py::object value = plain(given);
        if (value.is_none() || value.ptr() == Py_False) {
            continue;
        }
        words.push_back(value.ptr() == Py_True ? option : option + "=" + valueOf(value));
    }
    return words;
}

/// Options of the command that this call has not.
void refuse(const py::kwargs& options, std::initializer_list<std::string_view> refused,
            const std::string& instead) {
    for (const auto& [key, value] : options) {
        const std::string word = optionOf(key).substr(2);
        if (std::ranges::find(refused, word) != refused.end()) {
            throw Raised(pathOf(key) + ": " + instead);
        }
    }
}

void refuseExporting(const py::kwargs& options) {
    for (const FormatOption& row : formatOptions()) {
        refuse(options, {row.name}, "give it to write()");
    }
}

app::Arguments parsed(const char* command, const Words& inputs, const Words& words) {
    app::Arguments arguments = app::typedWords(command, inputs, words);
    if (arguments.command == app::Arguments::Command::Message) {
        throw Raised(app::withoutSpeaker(arguments.message));
    }
    return arguments;
}

void refuseReading(const app::Arguments& arguments) {
    if (!(arguments.load == app::Arguments{}.load) || !arguments.seams.empty()) {
        throw Raised("how files are read and cut is said to load() or garment()");
    }
}

void refuseFlattening(const app::Arguments& arguments) {
    if (!(arguments.stated == app::StatedOptions{})) {
        throw Raised("how pieces are flattened and drawn is said to flatten()");
    }
}

}  // namespace

std::string pathOf(const py::handle& path) {
    return py::module_::import("os").attr("fsencode")(path).cast<std::string>();
}

app::Arguments readingArguments(const Words& inputs, const py::kwargs& options) {
    refuse(options, {"help", "json", "advice"}, "is of the command line alone");
    return parsed("info", inputs, wordsOf(options));
}

app::Arguments flatteningArguments(const py::kwargs& options) {
    refuse(options, {"help", "ledger", "fail-on"}, "is of the command line alone");
    refuse(options, {"output", "report"}, "files are written by write()");
    refuseExporting(options);
    app::Arguments arguments = parsed("flatten", {kNoFile}, wordsOf(options));
    refuseReading(arguments);
    return arguments;
}

app::Arguments writingArguments(const Words& inputs, const Words& outputs,
                                const py::kwargs& options) {
    refuse(options, {"help", "ledger", "fail-on"}, "is of the command line alone");
    refuse(options, {"output", "report"}, "give the paths themselves");
    Words words;
    for (const std::string& output : outputs) {
        words.push_back("--output=" + output);
    }
    const Words more = wordsOf(options);
    words.insert(words.end(), more.begin(), more.end());
    app::Arguments arguments = parsed("flatten", inputs.empty() ? Words{kNoFile} : inputs, words);
    refuseReading(arguments);
    refuseFlattening(arguments);
    return arguments;
}

app::Arguments provingArguments(const py::kwargs& options) {
    refuse(options,
           {"help", "output", "report", "json", "view", "overlay", "size", "look", "dark", "sewn",
            "prove-improve", "rounds"},
           "is of the command line alone");
    app::Arguments arguments = parsed("prove", {kNoFile}, wordsOf(options));
    refuseReading(arguments);
    refuseFlattening(arguments);
    return arguments;
}

}  // namespace toile::python
