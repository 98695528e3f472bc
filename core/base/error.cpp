// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/error.h"

#include <cctype>

namespace toile {
namespace {

struct Words {
    std::string_view name;      ///< kebab-case, as in the report
    std::string_view describe;  ///< what happened
    std::string_view advice;    ///< what to try
    bool note = false;          ///< only informs
};

Words wordsOf(ErrorCode code) {
    switch (code) {
        case ErrorCode::FileUnreadable:
            return {"file-unreadable", "the file cannot be read", "Check its name and permissions"};
        case ErrorCode::FileUnwritable:
            return {"file-unwritable", "the file cannot be written",
                    "Check that the folder exists, is writable and has room"};
        case ErrorCode::UnknownFormat:
            return {"unknown-format", "the file's ending names no format Toile knows",
                    "Read .obj, .off, .ply or .stl; write .svg, .dxf, .obj or .json"};
        case ErrorCode::MalformedFile:
            return {"malformed-file", "the file breaks the rules of its format",
                    "Export it again from the program it came from"};
        case ErrorCode::NoGeometry:
            return {"no-geometry", "the file holds no faces",
                    "Export the garment as a mesh with faces"};
        case ErrorCode::UnitGuessed:
            return {"unit-guessed", "the file states no unit and its size leaves doubt",
                    "State the unit if the size is wrong", true};
        case ErrorCode::IndexOutOfRange:
            return {"index-out-of-range", "faces name vertices that the file does not have",
                    "They are left out; export the file again if something is missing", true};
        case ErrorCode::NonFinitePosition:
            return {"non-finite-position", "positions are not finite numbers",
                    "Faces on them are left out; export the file again if something is missing",
                    true};
        case ErrorCode::DegenerateFaceRecord:
            return {"degenerate-face-record", "faces have fewer than three different corners",
                    "They are left out", true};
        case ErrorCode::PolygonNotSimple:
            return {"polygon-not-simple", "polygons could not be divided by their shape",
                    "They are divided as a fan, which may fold over; triangulate them in the "
                    "modelling program",
                    true};
        case ErrorCode::UnusedVertices:
            return {"unused-vertices", "vertices belong to no face", "", true};
        case ErrorCode::OutputDiffers:
            return {"output-differs", "a mesh written from this file differs from it", "", true};
        case ErrorCode::EdgesCollapsed:
            return {"edges-collapsed", "edges have no length", "Their two ends are made one vertex",
                    true};
        case ErrorCode::FlatFacesRemoved:
            return {"flat-faces-removed", "triangles have no area",
                    "They are removed so that no hole opens", true};
        case ErrorCode::DuplicateFacesRemoved:
            return {"duplicate-faces-removed", "faces lie twice on the same vertices",
                    "One of each is kept", true};
        case ErrorCode::WindingsTurned:
            return {"windings-turned", "faces look to the other side than their neighbours",
                    "They are turned over to agree with the larger area", true};
        case ErrorCode::EdgesCutApart:
            return {"edges-cut-apart", "edges are shared by more than two faces",
                    "The faces that continue each other best stay joined; the others are cut free",
                    true};
        case ErrorCode::VerticesSplit:
            return {"vertices-split", "parts of the surface touch in a single vertex",
                    "Each part gets a vertex of its own", true};
        case ErrorCode::VerticesAdded:
            return {"vertices-added", "different edges of the surface join the same two vertices",
                    "All but one of them get a vertex in their middle", true};
        case ErrorCode::VerticesWelded:
            return {"vertices-welded", "vertices lie on each other without being joined",
                    "They are made one", true};
        case ErrorCode::HolesKept:
            return {"holes-kept", "holes in the cloth stay open inside the outline",
                    "The lengths of their rims are measured, not kept", true};
        case ErrorCode::OutlineCrosses:
            return {"outline-crosses", "the flat outline crosses itself",
                    "Divide the piece by a cut before it is cut out of cloth", true};
        case ErrorCode::OutlineUncrossed:
            return {"outline-uncrossed",
                    "the flat outline crossed itself and was moved apart, keeping its lengths", "",
                    true};
        case ErrorCode::DegenerateTriangles:
            return {"degenerate-triangles", "triangles have almost no height",
                    "The pattern may be uneven next to them; merge doubled vertices or remove the "
                    "slivers in the modelling program",
                    true};
        case ErrorCode::AnglesOutOfRange:
            return {"angles-out-of-range",
                    "the surface's curvature asks for corners that no flat outline has",
                    "Cut the piece where it curves most if the pattern looks folded there", true};
        case ErrorCode::EndedEarly:
            return {"ended-early", "the method ended before it reached its goal",
                    "The pattern can be used as it is; look for slivers in the piece, or cut it "
                    "where it curves most",
                    true};
        case ErrorCode::ClosedSurface:
            return {"closed-surface", "the piece is closed and has no outline",
                    "Cut it open along a seam, or let Toile do it (--auto-cut)"};
        case ErrorCode::SeveralLoops:
            return {"several-loops", "the piece has several boundary loops",
                    "Cut it from loop to loop, or let Toile do it (--auto-cut)"};
        case ErrorCode::Handle:
            return {"handle", "the piece has a handle, like a ring or a cup",
                    "Cut the handle open along a seam, or let Toile do it (--auto-cut)"};
        case ErrorCode::NonManifoldEdge:
            return {"non-manifold-edge", "edges are shared by more than two faces",
                    "Separate the layers that meet there"};
        case ErrorCode::NonManifoldVertex:
            return {"non-manifold-vertex", "parts of the piece touch in a single vertex",
                    "Separate the parts, or join them along an edge"};
        case ErrorCode::OpposedWinding:
            return {"opposed-winding", "neighbouring faces look to opposite sides",
                    "Make the normals consistent in the modelling program"};
        case ErrorCode::NotOrientable:
            return {"not-orientable", "the piece has one side only, like a Moebius strip",
                    "Cut it across"};
        case ErrorCode::DuplicateFace:
            return {"duplicate-face", "faces lie twice on the same vertices",
                    "Remove the doubled faces in the modelling program"};
        case ErrorCode::DegenerateFace:
            return {"degenerate-face", "triangles have no area",
                    "Merge doubled vertices or remove the slivers in the modelling program"};
        case ErrorCode::ZeroLengthEdge:
            return {"zero-length-edge", "boundary edges have no length",
                    "Merge the doubled vertices in the modelling program"};
        case ErrorCode::CutImpossible:
            return {"cut-impossible", "the cut cannot be made",
                    "Move its points, or mend the piece first"};
        case ErrorCode::NoSuchSeam:
            return {"no-such-seam", "the garment has no seam of this name",
                    "See the names with \"toile info\""};
        case ErrorCode::NoClosedOutline:
            return {"no-closed-outline",
                    "one boundary edge is as long as all the others together, so that no flat "
                    "outline has these lengths",
                    "Refine the boundary or move the seam"};
        case ErrorCode::BoundaryNotConverged:
            return {"boundary-not-converged",
                    "no closed outline near the surface's angles was found",
                    "Cut the piece where it curves most, or choose the other boundary solver"};
        case ErrorCode::FactorisationFailed:
            return {"factorisation-failed", "the interior's equations could not be solved",
                    "Look for slivers and extreme differences of edge length in the piece"};
        case ErrorCode::NotFinite:
            return {"not-finite", "the result is not a finite number",
                    "Look for extreme coordinates in the piece"};
        case ErrorCode::OutOfMemory:
            return {"out-of-memory", "there is not enough memory",
                    "Close other programs, or flatten fewer or coarser pieces at a time"};
        case ErrorCode::Cancelled:
            return {"cancelled", "cancelled", ""};
    }
    return {"unknown", "unknown error", ""};  // unreachable: the switch has every code
}

}  // namespace

std::string_view name(ErrorCode code) {
    return wordsOf(code).name;
}

std::string_view describe(ErrorCode code) {
    return wordsOf(code).describe;
}

std::string_view advice(ErrorCode code) {
    return wordsOf(code).advice;
}

bool isNote(ErrorCode code) {
    return wordsOf(code).note;
}

std::string sentence(const Error& error) {
    const Words words = wordsOf(error.code);
    std::string text;
    if (!error.where.empty()) {
        text += error.where + ": ";
    }
    text += words.describe;
    if (!error.detail.empty()) {
        text += " (" + error.detail + ")";
    }
    if (!words.advice.empty()) {
        text += "; ";
        text += static_cast<char>(std::tolower(static_cast<unsigned char>(words.advice.front())));
        text += words.advice.substr(1);
    }
    return text + ".";
}

}  // namespace toile
