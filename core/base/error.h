// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/id.h"
#include "core/base/wording.h"

namespace toile {

/// Everything that can be expected to go wrong, or that a user should know about. The kebab-case
/// `name` of a code is what the JSON report prints, so a code once released keeps its name.
enum class ErrorCode {
    // Files
    FileUnreadable,
    FileUnwritable,
    UnknownFormat,
    FormatNotBuilt,
    NotReadBack,
    PageTooSmall,
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
    ReadAs,
    CannotReadAs,
    LooksLikeScan,
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
    LineNotDrawn,
    LineYields,
    LeftOut,
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
    NoBodySeen,
    JoinImpossible,
    NoSuchSeam,
    // Solving
    NoClosedOutline,
    BoundaryNotConverged,
    OutlineNotHeld,
    FactorisationFailed,
    NotFinite,
    OutOfMemory,
    Cancelled,
    // Seams: they are sewn, with a note
    SeamsByNearness,
    // Lines: they are drawn, with a note
    LineStrays,
};

/// One past the last code; codes are contiguous from 0.
inline constexpr int kErrorCodeCount = static_cast<int>(ErrorCode::LineStrays) + 1;

/// The one thing that something is said of: found again by its kind and id, shown by its name.
struct Subject {
    enum class Kind { None, File, Piece, Seam, Cut, Join };

    Kind kind = Kind::None;  ///< None: everything there is
    std::uint64_t id = 0;    ///< of its kind; 0 where it is not known, or not there
    std::string name;        ///< for people; of several alike, a list of them

    Subject() = default;
    Subject(Kind k, std::uint64_t i, std::string called)
        : kind(k), id(i), name(std::move(called)) {}
    static Subject file(std::string name, FileId id = {}) {
        return {Kind::File, id.value, std::move(name)};
    }
    static Subject piece(std::string name, PieceId id = {}) {
        return {Kind::Piece, id.value, std::move(name)};
    }
    static Subject seam(std::string name, SeamId id = {}) {
        return {Kind::Seam, id.value, std::move(name)};
    }
    static Subject cut(std::string name, CutId id = {}) {
        return {Kind::Cut, id.value, std::move(name)};
    }
    static Subject join(std::string name) { return {Kind::Join, 0, std::move(name)}; }

    /// None where it is no piece, or one that is not known.
    PieceId pieceId() const { return {kind == Kind::Piece ? id : 0}; }
    bool operator==(const Subject&) const = default;
};

/// An expected failure or a note: what, about what, and the particulars. Never thrown.
struct Error {
    ErrorCode code;
    Subject subject{};
    Wording detail{};  ///< the particulars: counts, places, numbers
};

using Problems = std::vector<Error>;

/// What is to be said alike of several things of a kind: of each where they are few, else in one.
Problems aboutEach(ErrorCode code, const std::vector<Subject>& subjects,
                   const Wording& detail = {});

/// Stable kebab-case name, for example "several-loops".
std::string_view name(ErrorCode code);
/// What happened, in plain words, without a full stop.
std::string_view describe(ErrorCode code);
/// What the user can do about it, as a sentence without a full stop; empty where nothing is needed.
/// In words for the window and the command line alike.
std::string_view advice(ErrorCode code);
/// What is typed on the command line for it: "--auto-cut"; empty where there is nothing.
std::string_view commandLineOption(ErrorCode code);
/// True where the code only informs: the data was taken in and work goes on.
bool isNote(ErrorCode code);
/// Characters of name and `detail` that a sentence shows: a path, and a list of particulars.
inline constexpr std::size_t kMaxOfPlace = 300, kMaxOfDetail = 1000;
/// One sentence for a person at a command line, with the option that helps: "front: the piece has
/// several boundary loops (2 loops); cut it ...".
std::string sentence(const Error& error);

}  // namespace toile
