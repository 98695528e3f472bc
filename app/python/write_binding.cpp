// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <pybind11/stl.h>

#include "app/cli/command_line.h"
#include "app/python/flat_binding.h"
#include "app/python/interruptible_call.h"
#include "app/python/option_words.h"
#include "app/python/raised.h"
#include "core/formats/export_file.h"
#include "core/formats/formats.h"

namespace toile::python {
namespace {

std::vector<Exported> write(const PyFlat& flat, const py::args& paths, const py::object& onProgress,
                            const py::kwargs& options) {
    std::vector<std::string> outputs;
    for (const py::handle path : paths) {
        outputs.push_back(pathOf(path));
    }
    const app::Arguments typed = writingArguments(flat.held->of->inputs, outputs, options);
    return interruptible(onProgress, [&](Progress& progress) {
        if (const auto refusal = app::refusalOfNoPattern(flat.held->results, typed.outputs)) {
            throw Raised(*refusal);
        }
        const ExportSource source = flat.held->pattern().source(typed.exporting);
        std::vector<Exported> written;
        for (const auto& output : typed.outputs) {
            written.push_back(
                orRaise(exportFile(output, source, Progress(progress, 1.0 / outputs.size()))));
        }
        return written;
    });
}

/// Exports to bytes instead of a file.
std::string bytesAs(const PyFlat& flat, FormatId format, const ExportOptions& options = {}) {
    return interruptible(py::none(), [&](Progress&) {
        ExportedFiles files = orRaise(formatOf(format).write(flat.held->pattern().source(options)));
        return std::move(files.front().bytes);
    });
}

std::vector<py::str> filesOf(const Exported& written) {
    std::vector<py::str> files;
    for (const auto& file : written.files) {
        files.push_back(textOf(file.string()));
    }
    return files;
}

std::string said(const Exported& written) {
    return written.files.front().string() +
           (written.readBack ? "; " + readBackSentence(*written.readBack) : std::string()) +
           (written.notes.empty() ? "" : "; " + std::string(written.notes.front()));
}

}  // namespace

void bindWriting(py::module_& module, py::class_<PyFlat>& flat) {
    py::class_<Exported>(module, "Written",
                         "A file that has been written, read back and compared if its format "
                         "allows it. str() is a sentence.")
        .def_property_readonly("files", &filesOf,
                               "List of paths: the one asked for, then those beside it.")
        .def_property_readonly(
            "pieces",
            [](const Exported& self) {
                return self.readBack ? std::optional(self.readBack->pieces) : std::nullopt;
            },
            "Pieces found when it was read back; None of a format that is not read back.")
        .def_property_readonly(
            "largest_difference",
            [](const Exported& self) {
                return self.readBack ? std::optional(self.readBack->largest) : std::nullopt;
            },
            "Of any coordinate or length read back, mm; None likewise.")
        .def_property_readonly(
            "notes",
            [](const Exported& self) {
                std::vector<py::str> notes;
                for (const Wording& note : self.notes) {
                    notes.push_back(textOf(std::string(note)));
                }
                return notes;
            },
            "List of sentences on what the format cannot hold, such as names that were changed.")
        .def("__str__", [](const Exported& self) { return textOf(said(self)); })
        .def("__repr__",
             [](const Exported& self) { return textOf("<toile.Written " + said(self) + ">"); });
    flat.def("write", &write, py::arg("progress") = py::none(),
             R"(Writes files, each by its ending, as `toile flatten -o` does. -> list of Written

Every file is read back and compared with the pattern before it takes the place of an old one.
Where no piece lies flat, only reports are written: .json, .html, .csv.
Others: the options of formats: dxf_preset="clo", paper="a4", svg_text="paths", mesh_uv="exact".
Runs without the interpreter's lock. Raises FileError, UsageError.)")
        .def(
            "report",
            [](const PyFlat& self) {
                return py::module_::import("json").attr("loads")(
                    py::bytes(bytesAs(self, FormatId::Report)));
            },
            "The JSON report as a dictionary (docs/report.md).")
        .def(
            "_repr_svg_", [](const PyFlat& self) { return bytesAs(self, FormatId::Svg); },
            "The pattern as a notebook shows it.");
    module.def(
        "formats",
        [] {
            std::vector<std::string> endings;
            for (const Format& format : formats()) {
                if (format.write) {
                    endings.insert(endings.end(), format.endings.begin(), format.endings.end());
                }
            }
            return endings;
        },
        "List of the endings that write() knows.");
}

}  // namespace toile::python
