// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/python/flat_binding.h"

#include <optional>
#include <utility>

#include <pybind11/stl.h>

#include "app/cli/command_line.h"
#include "app/python/array_views.h"
#include "app/python/checked_call.h"
#include "app/python/interruptible_call.h"
#include "app/python/option_words.h"
#include "app/python/raised.h"
#include "core/diagnose/doubt.h"
#include "core/quality/measures.h"
#include "core/seam/seam_measure.h"

namespace toile::python {
namespace {

/// A seam of a flat garment.
struct PyFlatSeam {
    std::shared_ptr<const HeldFlat> held;
    std::size_t index;
    std::optional<SeamMeasure> measure;

    const Seam& seam() const { return held->garment().seams.seams[index]; }
};

Identity identityOf(const PyFlatSeam& seam) {
    return {seam.held.get(), seam.index};
}

PyFlat flatten(const PyGarment& garment, int threads, const py::object& onProgress,
               const py::kwargs& options) {
    app::Arguments typed = flatteningArguments(threads, options);
    auto held = std::make_shared<HeldFlat>();
    held->of = garment.held;
    app::Arguments& arguments = held->arguments;
    arguments = garment.held->arguments;
    if (const auto& project = arguments.project) {
        typed = app::withSettingsOf(*project, std::move(typed));
    }
    arguments.options = typed.options;
    arguments.lines = std::move(typed.lines);
    arguments.byHalf = typed.byHalf;
    arguments.threads = typed.threads;
    held->results = interruptible(onProgress, [&](Progress& progress) {
        return app::flattened(arguments, garment.held->garment, progress);
    });
    return {std::move(held)};
}

/// The principal strains of each triangle, the larger one first.
py::object strainOf(const PieceResult& result) {
    if (!result.flat) {
        return py::none();
    }
    const Eigen::MatrixX2d singular = singularValues(result.piece->mesh, result.flat->Q);
    Points2 strain(singular.rows(), 2);
    strain.col(0) = singular.col(1).cwiseInverse().array() - 1;
    strain.col(1) = singular.col(0).cwiseInverse().array() - 1;
    return owned(std::move(strain));
}

py::object qualityOf(const PieceResult& result) {
    if (!result.quality) {
        return py::none();
    }
    const PieceQuality& q = *result.quality;
    py::dict figures;
    figures["area3d"] = q.area3d;
    figures["area2d"] = q.area2d;
    figures["perimeter3d"] = q.perimeter3d;
    figures["perimeter2d"] = q.perimeter2d;
    figures["max_boundary_length_error"] = q.maxBoundaryLengthError;
    figures["symmetric_dirichlet"] = q.symmetricDirichlet;
    figures["quasi_conformal_mean"] = q.quasiConformalMean;
    figures["quasi_conformal_max"] = q.quasiConformalMax;
    figures["strain_min"] = q.strainMin;
    figures["strain_max"] = q.strainMax;
    figures["strain_mean_abs"] = q.strainMeanAbs;
    figures["flipped_triangles"] = q.flippedTriangles;
    figures["outline_crossings"] = q.outlineCrossings;
    return figures;
}

void bindFlatPiece(py::module_& module) {
    py::class_<PyFlatPiece> type(module, "FlatPiece",
                                 "A piece after flattening: flat, or the reason why not.");
    bindIdentity(type);
    type.def_property_readonly(
            "name", [](const PyFlatPiece& self) { return self.result->piece->name; },
            "As the piece of the garment.")
        .def_property_readonly(
            "piece", [](const PyFlatPiece& self) { return PyPiece{self.result->piece}; },
            "Piece: as it is worn, with the same vertices and faces.")
        .def_property_readonly(
            "positions",
            [](const py::object& self) -> py::object {
                const auto& flat = self.cast<const PyFlatPiece&>().result->flat;
                return flat ? py::object(view(flat->Q, self)) : py::none();
            },
            "float64 (V, 2), mm, y up, never mirrored; read-only. None where it is not flat.")
        .def_property_readonly(
            "line",
            [](const py::object& self) -> py::object {
                const auto& flat = self.cast<const PyFlatPiece&>().result->flat;
                return flat && flat->line ? py::object(view(flat->line->points, self)) : py::none();
            },
            "float64 (n, 2), mm: the outline as it is drawn, where that is not the polygon of its "
            "vertices; else None.")
        .def_property_readonly(
            "strain", [](const PyFlatPiece& self) { return strainOf(*self.result); },
            "float64 (F, 2): principal strains of each triangle, the larger one first, parts of "
            "1: 0.02 is cloth that has to stretch by 2 % to take the form it is worn in. Found "
            "when asked for. None where it is not flat.")
        .def_property_readonly(
            "status", [](const PyFlatPiece& self) { return std::string(statusOf(*self.result)); },
            "\"flat\", \"flipped\" (flat, but triangles are flipped), \"left-out\" or \"failed\".")
        .def_property_readonly(
            "error", [](const PyFlatPiece& self) { return self.result->error; },
            "Problem: why it is not flat; or None.")
        .def_property_readonly(
            "quality", [](const PyFlatPiece& self) { return qualityOf(*self.result); },
            "Dictionary of figures as in the JSON report (mm, mm2, parts of 1; None where one "
            "would be infinite); None where it is not flat.")
        .def_property_readonly(
            "seconds", [](const PyFlatPiece& self) { return self.result->seconds; },
            "That flattening it took.")
        .def("__repr__", [](const PyFlatPiece& self) {
            return "<toile.FlatPiece " + self.result->piece->name + ": " +
                   std::string(statusOf(*self.result)) + ">";
        });
}

template <SeamSide Seam::*side>
py::object flatSide(const PyFlatSeam& self) {
    const SeamSide& stretch = self.seam().*side;
    if (stretch.piece < 0) {
        return py::none();
    }
    const auto& result = self.held->results[static_cast<std::size_t>(stretch.piece)];
    return result->flat ? owned(flatLine(stretch, *result->piece, *result->flat))
                        : py::object(py::none());
}

/// Figures of sewn seams only: a free edge has just one side.
template <double SeamMeasure::*figure>
std::optional<double> figureOfBoth(const PyFlatSeam& self) {
    const bool isSewn = self.measure && self.seam().right.piece >= 0;
    return isSewn ? std::optional((*self.measure).*figure) : std::nullopt;
}

void bindFlatSeam(py::module_& module) {
    py::class_<PyFlatSeam> type(module, "FlatSeam", "A seam, or a free edge, of a flat garment.");
    bindIdentity(type);
    type.def_property_readonly(
            "seam",
            [](const PyFlatSeam& self) {
                return PySeam{self.held->of, self.index};
            },
            "Seam: as it is on the garment.")
        .def_property_readonly(
            "name", [](const PyFlatSeam& self) { return self.seam().name; },
            "As the seam of the garment.")
        .def_property_readonly(
            "kind", [](const PyFlatSeam& self) { return std::string(name(self.seam().kind)); },
            "\"seam\", \"dart\", \"fold\" or \"free\".")
        .def_property_readonly(
            "left_length",
            [](const PyFlatSeam& self) {
                return self.measure ? std::optional(self.measure->length2dLeft) : std::nullopt;
            },
            "Of the left side in the pattern, mm; None where it is not flat.")
        .def_property_readonly(
            "right_length", &figureOfBoth<&SeamMeasure::length2dRight>,
            "Of the right side in the pattern, mm; None where it is not flat, and of a free edge.")
        .def_property_readonly(
            "ease", [](const PyFlatSeam& self) { return easeToldOf(self.seam()); },
            "How much longer the left side is meant to be, as a part of the right.")
        .def_property_readonly(
            "error", &figureOfBoth<&SeamMeasure::errorMm>,
            "left_length - (1 + ease) right_length, mm: what nobody wants; None where a side is "
            "not flat, and of a free edge.")
        .def_property_readonly("left_line", &flatSide<&Seam::left>,
                               "float64 (n, 2), mm: the left side in its piece's coordinates; or "
                               "None.")
        .def_property_readonly("right_line", &flatSide<&Seam::right>,
                               "float64 (n, 2), mm: the right side in its piece's coordinates; or "
                               "None.")
        .def("__repr__",
             [](const PyFlatSeam& self) { return "<toile.FlatSeam " + self.seam().name + ">"; });
}

std::vector<PyFlatPiece> flatPiecesOf(const PyFlat& flat) {
    std::vector<PyFlatPiece> pieces;
    for (const auto& result : flat.held->results) {
        pieces.push_back({result});
    }
    return pieces;
}

std::vector<PyFlatSeam> flatSeamsOf(const PyFlat& flat) {
    std::vector<PyFlatSeam> seams;
    const Garment& garment = flat.held->garment();
    for (std::size_t k = 0; k < garment.seams.seams.size(); ++k) {
        seams.push_back({flat.held, k, measured(garment, flat.held->results, static_cast<int>(k))});
    }
    return seams;
}

Problems flatProblemsOf(const PyFlat& flat) {
    Problems problems;
    for (const auto& result : flat.held->results) {
        if (result->error && !isLeftOut(*result)) {
            problems.push_back(*result->error);
        }
        if (result->flat) {
            problems.insert(problems.end(), result->flat->notes.begin(), result->flat->notes.end());
        }
    }
    return problems;
}

std::vector<Finding> doubtsOf(const PyFlat& flat) {
    const HeldFlat& held = *flat.held;
    return findDoubts(held.garment(), held.results,
                      fabricsOf(held.laid().pattern, held.pattern().fabric));
}

std::string nameOfResult(const std::shared_ptr<const PieceResult>& result) {
    return result->piece->name;
}

PyFlatPiece wrappedResult(const std::shared_ptr<const PieceResult>& result) {
    return {result};
}

}  // namespace

const FinishedPattern& HeldFlat::pattern() const {
    std::call_once(isMade_, [this] { pattern_ = app::finished(arguments, garment(), results); });
    return pattern_;
}

void bindFlat(py::module_& module, py::class_<PyGarment>& garment, py::class_<PyFlat>& flat) {
    bindFlatPiece(module);
    bindFlatSeam(module);
    bindIdentity(flat);
    const auto flattenChecked = [](const PyGarment& of, const py::object& threads,
                                   const py::object& onProgress, const py::kwargs& options) {
        return flatten(of, threadsOf(threads), onProgress, options);
    };
    garment.def("flatten", flattenChecked, py::arg("threads") = 0, py::arg("progress") = py::none(),
                R"(Flattens and measures every piece. -> FlatGarment

threads: how many pieces at once, at most 64; 0: as many as the machine has cores. The result is the same.
progress: called every 50 ms with the fraction done; an exception of it cancels, as Ctrl-C does.
Others: the options of `toile flatten` about methods, lines and patterns: method="lscm",
quality="fine", fair=0.5, true=True, mirror="auto", pattern=True, allowance=10, half=True.
Runs without the interpreter's lock. A piece that fails leaves the others alone: see
FlatPiece.error. Raises UsageError.)");
    flat.def_property_readonly(
            "garment", [](const PyFlat& self) { return PyGarment{self.held->of}; },
            "Garment: what was flattened.")
        .def_property_readonly("pieces", &flatPiecesOf,
                               "List of FlatPiece, one per piece of the garment, in its order.")
        .def_property_readonly("seams", &flatSeamsOf, "List of FlatSeam, in the garment's order.")
        .def_property_readonly("problems", &flatProblemsOf,
                               "List of Problem: why pieces are not flat, and what there is to "
                               "know of those that are.")
        .def_property_readonly(
            "doubts",
            [](const PyFlat& self) {
                std::vector<std::string> doubts;
                for (const Finding& doubt : doubtsOf(self)) {
                    doubts.push_back(sentence(doubt));
                }
                return doubts;
            },
            "List of sentences: why the pattern is most likely none that one could sew.")
        .def_property_readonly(
            "usable",
            [](const PyFlat& self) {
                return !hasFaults(self.held->garment(), self.held->results, doubtsOf(self));
            },
            "False where `toile flatten` would end with exit status 1.")
        .def(
            "__len__", [](const PyFlat& self) { return self.held->results.size(); },
            "Number of pieces.")
        .def(
            "__getitem__",
            [](const PyFlat& self, const py::object& key) {
                return itemsOf(self.held->results, key, &nameOfResult, &wrappedResult);
            },
            "The flat piece of an index or a name; a list of those of a slice.")
        .def(
            "__contains__",
            [](const PyFlat& self, const py::object& key) {
                return hasItem(self.held->results, key, &nameOfResult, &wrappedResult);
            },
            "Whether it has a piece of this name, or this flat piece.")
        .def("__repr__", [](const PyFlat& self) {
            return "<toile.FlatGarment: " + std::to_string(self.held->results.size()) +
                   " pieces by " + std::string(name(self.held->arguments.options.method)) + ">";
        });
}

}  // namespace toile::python
