// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/wording.h"

namespace toile {

/// Everything that can be expected to go wrong, or that a user should know about. The kebab-case
/// `name` of a code is what the JSON report prints, so a code once released keeps its name.
enum class ErrorCode {
    // Files
    FileUnreadable,
    FileUnwritable,
    UnknownFormat,
    MalformedFile,
    NoGeometry,
    MalformedProject,
    NewerProject,
    // Reading: the file is taken in, with a note
    UnitGuessed,
    IndexOutOfRange,
    NonFinitePosition,
    DegenerateFaceRecord,
    PolygonNotSimple,
    UnusedVertices,
    OutputDiffers,
    UnknownKey,
    FileChanged,
    PieceGone,
    EdgesCrowd,
    // Repairs: the mesh is put right, with a note
    EdgesCollapsed,
    FlatFacesRemoved,
    DuplicateFacesRemoved,
    WindingsTurned,
    EdgesCutApart,
    VerticesSplit,
    VerticesAdded,
    VerticesWelded,
    HolesKept,
    // Flattening: the piece lies flat, with a note
    OutlineCrosses,
    OutlineUncrossed,
    TrianglesFlipped,
    EdgesTooShort,
    DegenerateTriangles,
    AnglesOutOfRange,
    EndedEarly,
    RimsNotKept,
    // Pieces
    ClosedSurface,
    SeveralLoops,
    Handle,
    NonManifoldEdge,
    NonManifoldVertex,
    OpposedWinding,
    NotOrientable,
    DuplicateFace,
    DegenerateFace,
    ZeroLengthEdge,
    CutImpossible,
    JoinImpossible,
    NoSuchSeam,
    // Solving
    NoClosedOutline,
    BoundaryNotConverged,
    FactorisationFailed,
    NotFinite,
    OutOfMemory,
    Cancelled,
};

/// One past the last code; codes are contiguous from 0.
inline constexpr int kErrorCodeCount = static_cast<int>(ErrorCode::Cancelled) + 1;

/// An expected failure or a note: what, where, and the particulars. Never thrown.
struct Error {
    ErrorCode code;
    std::string where;  ///< the piece or file it is about; empty where it is about everything
    Wording detail;     ///< the particulars: counts, places, numbers
};

using Problems = std::vector<Error>;

/// What is to be said alike of several places: of each where they are few, else in one.
Problems aboutEach(ErrorCode code, const std::vector<std::string>& places,
                   const Wording& detail = {});

/// Stable kebab-case name, for example "several-loops".
std::string_view name(ErrorCode code);
/// What happened, in plain words, without a full stop.
std::string_view describe(ErrorCode code);
/// What the user can do about it, as a sentence without a full stop; empty where nothing is needed.
std::string_view advice(ErrorCode code);
/// True where `where` names a piece, if anything; else a file, a cut, a join or a seam, which may
/// be called like a piece.
bool namesPiece(ErrorCode code);
/// True where the code only informs: the data was taken in and work goes on.
bool isNote(ErrorCode code);
/// Characters of `where` and `detail` that a sentence shows: a path, and a list of particulars.
inline constexpr std::size_t kMostOfPlace = 300, kMostOfDetail = 1000;
/// One sentence for a person: "front: the piece has several boundary loops (2 loops); cut it ...".
std::string sentence(const Error& error);

}  // namespace toile
