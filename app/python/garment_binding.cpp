// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/python/garment_binding.h"

#include <cmath>

#include <pybind11/stl.h>

#include "app/python/array_views.h"
#include "app/python/option_words.h"
#include "core/mesh/mesh_arrays.h"
#include "core/seam/seam_measure.h"

namespace toile::python {
namespace {

/// A ten-thousandth of a millimetre per metre: above rounding, below any intended ease.
constexpr double kNoEase = 1e-7;

const Piece& pieceOf(const py::object& self) {
    return *self.cast<const PyPiece&>().piece;
}

std::vector<PyPiece> piecesOf(const PyGarment& garment) {
    std::vector<PyPiece> pieces;
    for (const auto& piece : garment.held->garment.pieces) {
        pieces.push_back({piece});
    }
    return pieces;
}

std::vector<PySeam> seamsOf(const PyGarment& garment) {
    std::vector<PySeam> seams;
    for (std::size_t k = 0; k < garment.held->garment.seams.seams.size(); ++k) {
        seams.push_back({garment.held, k});
    }
    return seams;
}

void bindPiece(py::module_& module) {
    py::class_<PyPiece> type(
        module, "Piece",
        "A part of the garment that is cut from one piece of cloth, as it is worn. Arrays are "
        "read-only views.");
    bindIdentity(type);
    type.def_property_readonly(
            "name", [](const PyPiece& self) { return self.piece->name; },
            "Unique within the garment.")
        .def_property_readonly(
            "vertices", [](const py::object& self) { return view(pieceOf(self).mesh.V, self); },
            "float64 (V, 3), mm, y up.")
        .def_property_readonly(
            "faces", [](const py::object& self) { return view(pieceOf(self).mesh.F, self); },
            "int32 (F, 3), anti-clockwise seen from the fabric's right side.")
        .def_property_readonly(
            "source_vertices",
            [](const py::object& self) { return view(pieceOf(self).sourceVertex, self); },
            "int32 (V,): the row of each vertex in what was read, or -1 of one that was added.")
        .def_property_readonly(
            "source_faces",
            [](const py::object& self) { return view(pieceOf(self).sourceFace, self); },
            "int32 (F,): the face of what was read that each triangle is of.")
        .def_property_readonly(
            "boundary", [](const py::object& self) { return view(pieceOf(self).boundary, self); },
            "int32 (B,): vertices of the outline, surface on its left; empty where there is a "
            "defect.")
        .def_property_readonly(
            "holes",
            [](const py::object& self) {
                std::vector<py::array> holes;
                for (const auto& hole : pieceOf(self).holes) {
                    holes.push_back(view(hole, self));
                }
                return holes;
            },
            "List of int32 (H,): loops of vertices that stay open.")
        .def_property_readonly(
            "reference",
            [](const py::object& self) -> py::object {
                const auto& panel = pieceOf(self).reference;
                return panel ? py::object(view(*panel, self)) : py::none();
            },
            "float64 (V, 2), mm: the designer's own panel, where the UV map carries it; or None.")
        .def_property_readonly(
            "area", [](const PyPiece& self) { return surfaceArea(self.piece->mesh); },
            "Of the cloth as it is worn, mm2.")
        .def_property_readonly(
            "file", [](const PyPiece& self) { return self.piece->file; },
            "Index of the file that it is of.")
        .def_property_readonly(
            "defect", [](const PyPiece& self) { return self.piece->defect; },
            "Problem: why it cannot be flattened as it is; or None.")
        .def("__repr__", [](const PyPiece& self) {
            return "<toile.Piece " + self.piece->name + ": " +
                   std::to_string(self.piece->mesh.F.rows()) + " triangles>";
        });
}

/// Binds the same properties for one side of a seam.
template <SeamSide Seam::*side>
void bindSide(py::class_<PySeam>& seam, const std::string& prefix, const char* line) {
    seam.def_property_readonly((prefix + "_piece").c_str(),
                               [](const PySeam& self) {
                                   const int piece = (self.seam().*side).piece;
                                   return piece < 0 ? py::object(py::none())
                                                    : py::object(py::int_(piece));
                               },
                               "Index of the piece on this side; None where the edge is free.")
        .def_property_readonly(
            (prefix + "_length").c_str(),
            [](const PySeam& self) {
                return (self.seam().*side).piece < 0 ? 0.0 : (self.seam().*side).length();
            },
            "Length of this side on the garment, mm; 0 where there is none.")
        .def_property_readonly(
            (prefix + "_line").c_str(),
            [](const PySeam& self) {
                const SeamSide& stretch = self.seam().*side;
                return owned(
                    stretch.piece < 0
                        ? Points3(0, 3)
                        : spaceLine(
                              stretch,
                              *self.held->garment.pieces[static_cast<std::size_t>(stretch.piece)]));
            },
            line);
}

void bindSeam(py::module_& module) {
    py::class_<PySeam> seam(module, "Seam",
                            "Which edge is sewn to which; or a free edge, whose right side is "
                            "none.");
    bindIdentity(seam);
    seam.def_property_readonly(
            "name", [](const PySeam& self) { return self.seam().name; },
            "\"front / sleeve_left\", \"back, dart 2\".")
        .def_property_readonly(
            "kind", [](const PySeam& self) { return std::string(name(self.seam().kind)); },
            "\"seam\", \"dart\", \"fold\" or \"free\".")
        .def_property_readonly(
            "gap", [](const PySeam& self) { return self.seam().gap; },
            "Mean distance of the two sides on the garment, mm.")
        .def_property_readonly(
            "ease", [](const PySeam& self) { return easeToldOf(self.seam()); },
            "How much longer the left side is meant to be, as a part of the right (0.1 = 10 %).")
        .def_property_readonly(
            "matches",
            [](const py::object& self) {
                const auto& matches = self.cast<const PySeam&>().seam().matches;
                static_assert(sizeof(SeamMatch) == 2 * sizeof(double));
                Points2 pairs(static_cast<Eigen::Index>(matches.size()), 2);
                for (std::size_t k = 0; k < matches.size(); ++k) {
                    pairs.row(static_cast<Eigen::Index>(k)) << matches[k].left, matches[k].right;
                }
                return owned(std::move(pairs));
            },
            "float64 (M, 2), mm: places on both outlines that come to lie on each other.")
        .def("__repr__",
             [](const PySeam& self) { return "<toile.Seam " + self.seam().name + ">"; });
    bindSide<&Seam::left>(seam, "left",
                          "float64 (n, 3), mm: this side on the garment, from its start.");
    bindSide<&Seam::right>(seam, "right",
                           "float64 (n, 3), mm: the other side, from the same start.");
}

std::string nameOfPiece(const std::shared_ptr<const Piece>& piece) {
    return piece->name;
}

PyPiece wrappedPiece(const std::shared_ptr<const Piece>& piece) {
    return {piece};
}

}  // namespace

std::optional<std::string> nameGiven(const py::object& key) {
    try {
        return pathOf(key);
    } catch (const py::error_already_set& error) {
        if (!error.matches(PyExc_UnicodeError)) {
            throw;
        }
        return std::nullopt;
    }
}

double easeToldOf(const Seam& seam) {
    const double ease = easeOf(seam);
    return std::abs(ease) < kNoEase ? 0 : ease;
}

Problems problemsOf(const HeldGarment& held) {
    Problems problems = held.notes;
    const auto add = [&problems](const Problems& more) {
        problems.insert(problems.end(), more.begin(), more.end());
    };
    for (const auto& file : held.garment.files) {
        add(file->problems);
    }
    add(held.garment.problems);
    for (const auto& piece : held.garment.pieces) {
        if (piece->defect) {
            problems.push_back(*piece->defect);
        }
    }
    return problems;
}

void bindGarment(py::module_& module, py::class_<PyGarment>& garment) {
    bindPiece(module);
    bindSeam(module);
    bindIdentity(garment);
    garment
        .def_property_readonly("pieces", &piecesOf,
                               "List of Piece, in the order of their first faces.")
        .def_property_readonly("seams", &seamsOf, "List of Seam: seams first, then free edges.")
        .def_property_readonly(
            "problems", [](const PyGarment& self) { return problemsOf(*self.held); },
            "List of Problem: all that was left out, repaired or guessed, and why pieces cannot "
            "lie flat.")
        .def_property_readonly(
            "unit",
            [](const PyGarment& self) {
                return self.held->garment.files.empty()
                           ? 1.0
                           : millimetresPer(self.held->garment.files.front()->unit);
            },
            "Millimetres in a unit of the first file's coordinates; `unit=` takes it again.")
        .def(
            "__len__", [](const PyGarment& self) { return self.held->garment.pieces.size(); },
            "Number of pieces.")
        .def(
            "__getitem__",
            [](const PyGarment& self, const py::object& key) {
                return itemsOf(self.held->garment.pieces, key, &nameOfPiece, &wrappedPiece);
            },
            "The piece of an index or a name; a list of those of a slice.")
        .def(
            "__contains__",
            [](const PyGarment& self, const py::object& key) {
                return hasItem(self.held->garment.pieces, key, &nameOfPiece, &wrappedPiece);
            },
            "Whether it has a piece of this name, or this piece.")
        .def("__repr__", [](const PyGarment& self) {
            const Garment& held = self.held->garment;
            return "<toile.Garment: " + std::to_string(held.pieces.size()) + " pieces, " +
                   std::to_string(held.seams.seams.size()) + " seams and free edges>";
        });
}

}  // namespace toile::python
