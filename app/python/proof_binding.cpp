// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <pybind11/stl.h>

#include "app/cli/command_line.h"
#include "app/python/array_views.h"
#include "app/python/flat_binding.h"
#include "app/python/interruptible_call.h"
#include "app/python/option_words.h"
#include "app/python/raised.h"
#include "core/prove/proof.h"

namespace toile::python {
namespace {

struct PyProof {
    std::shared_ptr<const HeldFlat> held;
    std::shared_ptr<const Proof> proof;
    std::vector<std::string> notes;
};

struct PyProvenPiece {
    PyProof of;
    std::size_t index;

    const ProvenPiece& piece() const { return of.proof->pieces[index]; }
};

Identity identityOf(const PyProof& proof) {
    return {proof.proof.get(), 0};
}
Identity identityOf(const PyProvenPiece& piece) {
    return {piece.of.proof.get(), piece.index};
}

PyProof prove(const PyFlat& flat, const py::object& onProgress, const py::kwargs& options) {
    app::Arguments typed = provingArguments(options);
    const HeldFlat& held = *flat.held;
    if (const auto& project = held.arguments.project) {
        typed = app::withSettingsOf(*project, std::move(typed));
        typed.project = project;
    }
    return interruptible(onProgress, [&](Progress& progress) {
        const ProofOrder order = orRaise(app::proofOrder(typed, held.garment(), progress));
        FinishedPattern pattern = held.pattern();
        pattern.fabric = typed.fabric.value_or(pattern.fabric);
        auto proof = proofOf(pattern.source(), order, progress);
        if (!proof) {
            throw Raised(app::refusalOfProof(proof.error(), held.results));
        }
        return PyProof{flat.held, *std::move(proof), app::notesOf(order)};
    });
}

py::dict spread(const sew::SpreadFigures& figures) {
    py::dict told;
    told["mean"] = figures.mean;
    told["p95"] = figures.most95;
    told["max"] = figures.max;
    return told;
}

void bindProvenPiece(py::module_& module) {
    const auto provenPiece = [](const py::object& self) -> const ProvenPiece& {
        return self.cast<const PyProvenPiece&>().piece();
    };
    py::class_<PyProvenPiece> type(
        module, "ProvenPiece",
        "A piece of the garment, sewn. Its arrays are empty where it has no cloth.");
    bindIdentity(type);
    type.def_property_readonly(
            "name",
            [](const PyProvenPiece& self) {
                return self.of.held->garment().pieces[self.index]->name;
            },
            "As the piece of the garment.")
        .def_property_readonly(
            "sewn",
            [provenPiece](const py::object& self) { return view(provenPiece(self).sewn, self); },
            "float64 (V, 3), mm: where each vertex of the piece comes to lie.")
        .def_property_readonly(
            "gap",
            [provenPiece](const py::object& self) { return view(provenPiece(self).gap, self); },
            "float64 (V,), mm: how far outside of the design each vertex lies; inside below 0.")
        .def_property_readonly(
            "strain",
            [provenPiece](const py::object& self) { return view(provenPiece(self).strain, self); },
            "float64 (V,), parts of 1: the principal strain of larger size there; above 0 pulls.")
        .def_property_readonly(
            "gap_mm", [](const PyProvenPiece& self) { return spread(self.piece().gapFigures); },
            "Dictionary mean, p95, max of the gap's size over its area, mm.")
        .def_property_readonly(
            "free_share", [](const PyProvenPiece& self) { return self.piece().freeShare; },
            "Of its area that touches nothing, part of 1.")
        .def("__repr__", [](const PyProvenPiece& self) {
            return "<toile.ProvenPiece " + self.of.held->garment().pieces[self.index]->name + ">";
        });
}

std::vector<py::dict> provenSeamsOf(const PyProof& self) {
    std::vector<py::dict> seams;
    for (const ProvenSeam& seam : self.proof->seams) {
        py::dict told;
        told["seam"] = seam.seam;
        told["left_length"] = seam.left;
        told["right_length"] = seam.right;
        told["slip"] = seam.slip;
        told["strain"] = seam.strain;
        seams.push_back(told);
    }
    return seams;
}

std::vector<py::dict> faultsOf(const PyProof& self) {
    std::vector<py::dict> faults;
    for (const Finding& fault : self.proof->faults) {
        py::dict told;
        told["kind"] = std::string(name(fault.kind));
        told["subject"] = fault.subject.name;
        told["pieces"] = fault.pieces;
        told["seam"] = fault.seam < 0 ? py::object(py::none()) : py::object(py::int_(fault.seam));
        told["amount"] = fault.badness;
        told["told"] = std::string(fault.reason);
        faults.push_back(told);
    }
    return faults;
}

}  // namespace

void bindProof(py::module_& module, py::class_<PyFlat>& flat) {
    bindProvenPiece(module);
    py::class_<PyProof> type(module, "Proof",
                             "A pattern sewn back together over its design, and measured. str() "
                             "is a sentence.");
    bindIdentity(type);
    type.def_property_readonly(
            "gap", [](const PyProof& self) { return spread(self.proof->gap); },
            "Dictionary mean, p95, max: how far the cloth rests from the design, mm.")
        .def_property_readonly(
            "strain", [](const PyProof& self) { return spread(self.proof->strain); },
            "Dictionary mean, p95, max of the sizes of strains, parts of 1.")
        .def_property_readonly(
            "free_share", [](const PyProof& self) { return self.proof->freeShare; },
            "Of the cloth's area that touches nothing, part of 1.")
        .def_property_readonly(
            "pieces",
            [](const PyProof& self) {
                std::vector<PyProvenPiece> pieces;
                for (std::size_t k = 0; k < self.proof->pieces.size(); ++k) {
                    pieces.push_back({self, k});
                }
                return pieces;
            },
            "List of ProvenPiece, one per piece of the garment.")
        .def_property_readonly("seams", &provenSeamsOf,
                               "List of dictionaries of the seams that are sewn: seam (index), "
                               "left_length, right_length, slip, mm, and strain, part of 1.")
        .def_property_readonly("faults", &faultsOf,
                               "List of dictionaries: what is wrong with the pattern before "
                               "anything is sewn, by kind, subject, pieces, seam, amount, told.")
        .def_property_readonly(
            "notes", [](const PyProof& self) { return self.notes; },
            "List of sentences: what reading the pattern's file left out or put right.")
        .def_property_readonly(
            "has_settled", [](const PyProof& self) { return self.proof->hasSettled; },
            "Whether the cloth came to rest.")
        .def(
            "report",
            [](const PyProof& self) {
                return py::module_::import("json").attr("loads")(
                    writeProof(self.held->garment(), *self.proof));
            },
            "The proof's JSON as a dictionary (docs/prove.md).")
        .def("__str__",
             [](const PyProof& self) {
                 return std::string(sentence(*self.proof, self.held->garment()));
             })
        .def("__repr__", [](const PyProof& self) {
            return "<toile.Proof: " + std::string(sentence(*self.proof, self.held->garment())) +
                   ">";
        });
    flat.def("prove", &prove, py::arg("progress") = py::none(),
             R"(Sews the pattern back together over the design. -> Proof

Others: the options of `toile prove`: pattern="file.dxf", reference="uv", body="avatar.obj",
body_unit="cm", scale=0.97, edge=10, stretch=(900, 700), gravity=True, fabric="denim", threads=2.
Takes seconds; runs without the interpreter's lock, Ctrl-C ends it. Raises Error, FileError,
UsageError.)");
}

}  // namespace toile::python
