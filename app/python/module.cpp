// SPDX-License-Identifier: GPL-3.0-or-later
// The Python module: a thin layer over the pipeline, like the command line. It shares the command
// line's parser and returns views of the core's data.
#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "app/cli/command_line.h"
#include "app/python/flat_binding.h"
#include "app/python/garment_binding.h"
#include "app/python/interruptible_call.h"
#include "app/python/option_words.h"
#include "app/python/raised.h"
#include "app/python/running_calls.h"
#include "core/base/version.h"
#include "core/io/soup_builder.h"
#include "core/project/piece_names.h"

namespace toile::python {
namespace {

namespace py = pybind11;
using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Ints = py::array_t<int, py::array::c_style | py::array::forcecast>;

/// The text of a seams file; nullopt if the arguments name a file.
using SeamsText = std::optional<std::string>;

/// Removes `seams` from the options if it is a mapping instead of a path.
SeamsText takeSeams(py::kwargs& options) {
    const py::object mapping = py::module_::import("collections.abc").attr("Mapping");
    if (!options.contains("seams") || !py::isinstance(options["seams"], mapping)) {
        return std::nullopt;
    }
    const py::object plain = py::module_::import("toile").attr("_plain");
    const py::object text =
        py::module_::import("json").attr("dumps")(options["seams"], py::arg("default") = plain);
    options["seams"] = "the seams given";
    return text.cast<std::string>();
}

void readSeams(HeldGarment& held, const SeamsText& text) {
    if (held.arguments.seams.empty()) {
        return;
    }
    auto seams = text ? parseSeamsFile(*text, "seams", &held.notes)
                      : readSeamsFile(held.arguments.seams, &held.notes);
    held.arguments.load.seams = orRaise(std::move(seams));
}

PyGarment finished(HeldGarment held, Garment garment) {
    if (const auto& project = held.arguments.project) {
        const Problems differences = differencesTo(*project, garment);
        held.notes.insert(held.notes.end(), differences.begin(), differences.end());
        garment = named(std::move(garment), project->labels);
    }
    held.garment = std::move(garment);
    return {std::make_shared<const HeldGarment>(std::move(held))};
}

PyGarment load(const std::vector<std::string>& paths, const py::object& onProgress,
               py::kwargs options) {
    const SeamsText seams = takeSeams(options);
    const app::Arguments typed = readingArguments(paths, options);
    return interruptible(onProgress, [&](Progress& progress) {
        app::Messages notes;
        HeldGarment held{.arguments = orRaise(app::withProject(typed, notes)), .garment = {}};
        for (const auto& input : held.arguments.inputs) {
            held.inputs.push_back(input.string());
        }
        readSeams(held, seams);
        Garment garment =
            orRaise(loadGarment(held.arguments.inputs, held.arguments.load, progress));
        return finished(std::move(held), std::move(garment));
    });
}

ArrayNames namesOf(const std::pair<std::vector<std::string>, Ints>& given) {
    return {given.first, {given.second.data(), static_cast<std::size_t>(given.second.size())}};
}

template <class Array>
auto spanOf(const Array& array) {
    return std::span(array.data(), static_cast<std::size_t>(array.size()));
}

using NamesGiven = std::pair<std::vector<std::string>, Ints>;

PyGarment garmentOfArrays(const Doubles& positions, const Ints& faceStart, const Ints& corners,
                          const Doubles& uvs, const Ints& cornerUvs, const NamesGiven& objects,
                          const NamesGiven& groups, const NamesGiven& materials,
                          const std::string& name, int decimals, const py::object& onProgress,
                          py::kwargs options) {
    const SeamsText seams = takeSeams(options);
    if (name.find('\0') != std::string::npos) {  // a path would end there
        throw Raised(app::usageRefusal("name has a zero byte, which no file's name can have"));
    }
    HeldGarment held{.arguments = readingArguments({"garment"}, options), .garment = {}};
    held.arguments.inputs = {name};
    const MeshInArrays mesh{.positions = spanOf(positions),
                            .uvs = spanOf(uvs),
                            .faceStart = spanOf(faceStart),
                            .corners = spanOf(corners),
                            .cornerUvs = spanOf(cornerUvs),
                            .objects = namesOf(objects),
                            .groups = namesOf(groups),
                            .materials = namesOf(materials),
                            .decimals = decimals};
    return interruptible(onProgress, [&](Progress& progress) {
        readSeams(held, seams);
        auto soup = std::make_shared<const PolygonSoup>(orRaise(soupOfArrays(mesh, name)));
        Garment garment = orRaise(makeGarment(
            {.files = {{.path = name, .soup = std::move(soup)}}, .loading = held.arguments.load},
            progress));
        return finished(std::move(held), std::move(garment));
    });
}

/// Binds `load` and `garment_of_arrays`.
void bindLoading(py::module_& module) {
    module.def("load", &load, py::arg("paths"), py::arg("progress") = py::none(),
               "Reads files as one garment; see toile.load.");
    module.def("garment_of_arrays", &garmentOfArrays, py::arg("positions"), py::arg("face_start"),
               py::arg("corners"), py::arg("uvs"), py::arg("corner_uvs"), py::arg("objects"),
               py::arg("groups"), py::arg("materials"), py::arg("name"), py::arg("decimals"),
               py::arg("progress") = py::none(),
               "A garment of arrays whose sizes fit each other; see toile.garment.");
}

}  // namespace
}  // namespace toile::python

PYBIND11_MODULE(_core, module) {
    using namespace toile;
    namespace py = pybind11;
    module.doc() = "The compiled part of the package toile.";
    module.attr("__version__") = std::string(version());
    python::endCallsWithInterpreter();
    python::bindProblems(module);
    py::class_<python::PyGarment> garment(
        module, "Garment",
        "The pieces of one or several mesh files, cut and sewn. Immutable; may be used on several "
        "threads. Made by load() and garment().");
    py::class_<python::PyFlat> flat(
        module, "FlatGarment",
        "A garment whose pieces lie flat. Immutable; may be used on several threads. Made by "
        "Garment.flatten().");
    python::bindGarment(module, garment);
    python::bindLoading(module);
    python::bindFlat(module, garment, flat);
    python::bindWriting(module, flat);
    python::bindPattern(module, flat);
    python::bindProof(module, flat);
    module.def(
        "methods",
        [] {
            std::vector<std::string> names;
            for (const MethodTraits& method : allMethods()) {
                names.emplace_back(method.name);
            }
            return names;
        },
        "List of the names of methods, the one recommended first.");
}
