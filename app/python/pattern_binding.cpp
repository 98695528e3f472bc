// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>
#include <string>
#include <vector>

#include <pybind11/stl.h>

#include "app/python/array_views.h"
#include "app/python/flat_binding.h"
#include "app/python/running_calls.h"
#include "core/base/wording.h"
#include "core/formats/drawing/drawing.h"
#include "core/geometry/line.h"
#include "core/pattern/notch_mark.h"
#include "core/seam/seam_measure.h"

namespace toile::python {
namespace {

struct PyPattern {
    std::shared_ptr<const HeldFlat> held;
};

struct PyPatternPiece {
    std::shared_ptr<const HeldFlat> held;
    std::size_t index;

    const PatternPiece& piece() const { return held->laid().pattern.pieces[index]; }
};

Identity identityOf(const PyPattern& pattern) {
    return {pattern.held.get(), 0};
}
Identity identityOf(const PyPatternPiece& piece) {
    return {piece.held.get(), piece.index};
}

const PatternPiece& patternPiece(const py::object& self) {
    return self.cast<const PyPatternPiece&>().piece();
}

/// The 2 x 3 matrix that maps points of the piece to the sheet: [x y 1].
py::object placeOf(const PyPatternPiece& self) {
    for (const PlacedCopy& copy : self.held->laid().marker.copies) {
        if (copy.piece == static_cast<int>(self.index)) {
            Eigen::Matrix<double, 2, 3, Eigen::RowMajor> place;
            place << copy.placement.linear(), copy.placement.offset;
            return owned(place);
        }
    }
    return py::none();
}

std::vector<py::dict> notchesOf(const PyPatternPiece& self) {
    const PatternPiece& piece = self.piece();
    std::vector<py::dict> notches;
    for (const PieceNotch& notch : piece.notches) {
        const NotchSpot spot = notchSpot(notchLine(piece, notch.hole), notch.at);
        py::dict told;
        told["seam"] = notch.seam;
        told["share"] = notch.share;
        told["hole"] = notch.hole < 0 ? py::object(py::none()) : py::object(py::int_(notch.hole));
        told["at"] = notch.at;
        told["count"] = notch.count;
        told["reason"] = std::string(wordOf(kNotchReasonWords, notch.reason));
        told["point"] = owned(spot.point);
        told["outward"] = owned(spot.outward);
        notches.push_back(told);
    }
    return notches;
}

std::vector<py::dict> seamLinesOf(const py::object& self) {
    std::vector<py::dict> lines;
    for (const SeamLine& line : patternPiece(self).seams) {
        py::dict told;
        told["number"] = line.number;
        told["name"] = line.name;
        told["kind"] = std::string(name(line.kind));
        told["is_right"] = line.isRight;
        told["closed"] = line.closed;
        told["line"] = view(line.line, self);
        told["length3d"] = line.length3d;
        lines.push_back(told);
    }
    return lines;
}

std::vector<py::dict> segmentsOf(const PyPatternPiece& self) {
    std::vector<py::dict> segments;
    for (const PatternSegment& segment : self.piece().segments) {
        py::dict told;
        told["start"] = segment.from;
        told["end"] = segment.to;
        told["is_corner"] = segment.isCorner;
        told["is_fold"] = segment.isFold;
        told["seam"] = segment.seam;
        told["kind"] = std::string(name(segment.kind));
        if (segment.seam > 0 && segment.kind == SeamKind::Free) {
            told["edge"] = std::string(wordOf(kEdgeKindWords, segment.edge));
        }
        told["length"] = segment.length;
        told["allowance"] = segment.allowance;
        if (segment.limit != AllowanceLimit::None) {
            told["usual_allowance"] = segment.usualAllowance;
            told["limited_by"] = std::string(wordOf(kAllowanceLimitWords, segment.limit));
        }
        segments.push_back(told);
    }
    return segments;
}

std::vector<py::array> linesOf(const std::vector<Points2>& lines, const py::object& self) {
    std::vector<py::array> views;
    views.reserve(lines.size());
    for (const Points2& line : lines) {
        views.push_back(view(line, self));
    }
    return views;
}

void bindPatternPiece(py::module_& module) {
    py::class_<PyPatternPiece> type(
        module, "PatternPiece",
        "A piece as it is cut, in its own coordinates: mm, y up, the fabric's right side facing "
        "the reader. Arrays are read-only views.");
    bindIdentity(type);
    type.def_property_readonly(
            "name", [](const PyPatternPiece& self) { return self.piece().name; },
            "As it is called.")
        .def_property_readonly(
            "slug", [](const PyPatternPiece& self) { return self.piece().slug; },
            "Unique in the pattern; of ids in files.")
        .def_property_readonly(
            "outline",
            [](const py::object& self) { return view(patternPiece(self).outline, self); },
            "float64 (n, 2), mm: the seam line, anti-clockwise, first point not repeated; empty "
            "where it is not flat.")
        .def_property_readonly(
            "cutting_line",
            [](const py::object& self) { return view(edgeOf(patternPiece(self)), self); },
            "float64 (m, 2), mm: what it is cut along, allowances and all; the outline where it "
            "has none.")
        .def_property_readonly(
            "holes", [](const py::object& self) { return linesOf(patternPiece(self).holes, self); },
            "List of float64 (h, 2), mm: closed lines inside it, clockwise.")
        .def_property_readonly("seams", &seamLinesOf,
                               "List of dictionaries: each side of a seam, and each free edge, as "
                               "line (n, 2), mm, with number, name, kind and length3d.")
        .def_property_readonly(
            "segments", &segmentsOf,
            "List of dictionaries: the outline from turn to turn, with start "
            "and end, arc lengths along it, and allowance; all mm. Of allowances that "
            "are narrower than usual also usual_allowance and limited_by.")
        .def_property_readonly("notches", &notchesOf,
                               "List of dictionaries: point (2,), outward (2,), seam, share of "
                               "it, count, reason; mm.")
        .def_property_readonly(
            "internals",
            [](const py::object& self) {
                std::vector<py::dict> lines;
                for (const PieceInternal& line : patternPiece(self).internals) {
                    py::dict told;
                    told["name"] = line.name;
                    told["points"] = view(line.points, self);
                    told["closed"] = line.closed;
                    lines.push_back(told);
                }
                return lines;
            },
            "List of dictionaries: internal lines and drill points, points (n, 2), mm.")
        .def_property_readonly(
            "grain", [](const PyPatternPiece& self) { return self.piece().grain; },
            "Direction of the warp, radians from the x axis; None where it is unset.")
        .def_property_readonly(
            "quantity", [](const PyPatternPiece& self) { return self.piece().quantity; },
            "How many are cut.")
        .def_property_readonly("place", &placeOf,
                               "float64 (2, 3): takes points [x, y, 1] of the piece to the sheet, "
                               "mm; None where it is not drawn.")
        .def("__repr__", [](const PyPatternPiece& self) {
            return "<toile.PatternPiece " + self.piece().name + ">";
        });
}

}  // namespace

void bindPattern(py::module_& module, py::class_<PyFlat>& flat) {
    bindPatternPiece(module);
    py::class_<PyPattern> type(module, "Pattern", "What is cut: outlines, cutting lines, notches.");
    bindIdentity(type);
    type.def_property_readonly(
            "name", [](const PyPattern& self) { return self.held->laid().pattern.name; },
            "Of the garment.")
        .def_property_readonly(
            "pieces",
            [](const PyPattern& self) {
                std::vector<PyPatternPiece> pieces;
                for (std::size_t k = 0; k < self.held->laid().pattern.pieces.size(); ++k) {
                    pieces.push_back({self.held, k});
                }
                return pieces;
            },
            "List of PatternPiece: one per piece of the garment, then facings.")
        .def_property_readonly(
            "size",
            [](const PyPattern& self) {
                const Marker& marker = self.held->laid().marker;
                return std::pair(marker.width, marker.height);
            },
            "Width and height of the sheet that the pieces lie on, mm.")
        .def_property_readonly(
            "notes",
            [](const PyPattern& self) {
                const auto& [pattern, marker, whole, uv] = self.held->laid();
                std::vector<std::string> notes;
                for (const Wording& note : overlapNotes(pattern, draw(pattern, marker))) {
                    notes.push_back(note);
                }
                return notes;
            },
            "List of sentences: what to know before it is cut. Empty where all is well.")
        .def(
            "__len__",
            [](const PyPattern& self) { return self.held->laid().pattern.pieces.size(); },
            "Number of pieces.")
        .def("__repr__", [](const PyPattern& self) {
            return "<toile.Pattern " + self.held->laid().pattern.name + ">";
        });
    flat.def_property_readonly(
        "pattern",
        [](const PyFlat& self) {
            {
                Progress progress;
                const RunningCall running(progress);
                const py::gil_scoped_release released;
                self.held->laid();
            }
            return PyPattern{self.held};
        },
        "Pattern: what is cut, found when it is first asked for.");
}

}  // namespace toile::python
