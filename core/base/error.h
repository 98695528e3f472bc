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

/// Every failure to expect, and everything that a user should know about. The JSON report prints
/// the kebab-case `name` of a code, so a released code keeps its name.
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

/// The subject of a message, identified by its kind and id and displayed by its name.
struct Subject {
    enum class Kind { None, File, Piece, Seam, Cut, Join };

    Kind kind = Kind::None;  ///< None: everything there is
    std::uint64_t id = 0;    ///< of its kind; 0 if unknown or missing
    std::string name;        ///< for display; a list of names if several are meant

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

    /// No id if the subject is not a piece or its id is unknown.
    PieceId pieceId() const { return {kind == Kind::Piece ? id : 0}; }
    bool operator==(const Subject&) const = default;
};

/// An expected failure or a note: what, about what, and the details. Never thrown.
struct Error {
    ErrorCode code;
    Subject subject{};
    Wording detail{};  ///< counts, places, numbers
};

using Problems = std::vector<Error>;

/// Reports one problem of several things: a message for each if they are few, else one for all.
Problems aboutEach(ErrorCode code, const std::vector<Subject>& subjects,
                   const Wording& detail = {});

/// Stable kebab-case name, for example "several-loops".
std::string_view name(ErrorCode code);
/// What happened, in plain words, without a full stop.
std::string_view describe(ErrorCode code);
/// What the user can do about it, as a sentence without a full stop; empty if nothing is needed.
/// Worded for both the window and the command line.
std::string_view advice(ErrorCode code);
/// The command line option that helps: "--auto-cut"; empty if there is none.
std::string_view commandLineOption(ErrorCode code);
/// True if the code only informs: the data was accepted and work continues.
bool isNote(ErrorCode code);
/// Maximum characters that a sentence shows of the name (a path) and of `detail` (a list).
inline constexpr std::size_t kMaxOfPlace = 300, kMaxOfDetail = 1000;
/// The text for the command line, with the option that helps: "front: the piece has several
/// boundary loops (2 loops). Cut it ...".
std::string sentence(const Error& error);

/// A place in a sentence: its words, with the unit if there is one, "(1.0, 2.0, 3.0) mm", and its
/// position in mm with y up, with all digits except that a written 0.0 is 0.
struct PlaceInText {
    std::string words;
    std::array<double, 3> at{};
};

/// "1.0, 2.0, 3.0": a place like that of `placeWording`, without brackets.
Wording barePlaceWording(double x, double y, double z);

/// The places on the garment in `sentence(error)`, in order, without those that it cuts off and
/// those on the flat pattern. Callers with other axes or units can replace them in the sentence,
/// from the last to the first, because a name before a place may look like one.
std::vector<PlaceInText> placesIn(const Error& error);

}  // namespace toile
