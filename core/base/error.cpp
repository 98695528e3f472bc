// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/error.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <string_view>

#include "core/base/characters.h"
#include "core/base/setting.h"
#include "core/base/text.h"

namespace toile {
namespace {

struct Words {
    ErrorCode code;
    std::string_view name;      ///< kebab-case, as in the report
    std::string_view describe;  ///< what happened
    std::string_view advice;    ///< what to try
    bool note = false;          ///< only informs
    std::string_view option{};  ///< option to type on the command line
};

using enum ErrorCode;

/// In the order of the codes.
constexpr Words kWords[] = {
    {FileUnreadable, "file-unreadable", TR("the file cannot be read"),
     TR("Check its name and permissions")},
    {FileUnwritable, "file-unwritable", TR("the file cannot be written"),
     TR("Check that the folder exists, is writable and has free space")},
    {UnknownFormat, "unknown-format", TR("Toile does not know the format of the file"),
     TR("Export the garment as .obj"), false, "toile flatten --help lists the formats"},
    {FormatNotBuilt, "format-not-built", TR("this build of Toile cannot write the format"),
     TR("Use a build with the window")},
    {NotReadBack, "not-read-back",
     TR("the file does not match the pattern when read back, so it was not written"),
     TR("Use another format, and report this with the garment")},
    {PageTooSmall, "page-too-small", TR("the pattern does not fit the page"),
     TR("Choose larger paper, or move the pieces closer together")},
    {MalformedFile, "malformed-file", TR("the file breaks the rules of its format"),
     TR("Export it again from the program that made it")},
    {NoGeometry, "no-geometry", TR("the file contains no usable geometry"),
     TR("Export the garment as a mesh with faces, or the pattern with closed outlines")},
    {MalformedProject, "malformed-project", TR("the project file breaks the rules of its format"),
     TR("Open an older copy, or correct this place in a text editor")},
    {NewerProject, "newer-project", TR("the project was saved by a newer version of Toile"),
     TR("Update Toile to open it")},
    {UnitGuessed, "unit-guessed", TR("the unit is uncertain"),
     TR("Set the unit if the size is wrong"), true},
    {IndexOutOfRange, "index-out-of-range", TR("faces refer to vertices that do not exist"),
     TR("Export the file again if something is missing"), true},
    {NonFinitePosition, "non-finite-position",
     TR("positions are not finite numbers, so their faces are left out"),
     TR("Export the file again if something is missing"), true},
    {DegenerateFaceRecord, "degenerate-face-record",
     TR("faces have fewer than three different corners"),
     TR("Export the file again if something is missing"), true},
    {PolygonNotSimple, "polygon-not-simple",
     TR("polygons could not be split into triangles cleanly"),
     TR("Check whether they fold over; if so, triangulate them in the modelling program"), true},
    {UnusedVertices, "unused-vertices", TR("vertices belong to no face"), "", true},
    {OutputDiffers, "output-differs", TR("a mesh written from this file differs from it"), "",
     true},
    {UnknownKey, "unknown-key", TR("the file has entries that this version does not know"),
     TR("Check their spelling; saving from this version removes them"), true},
    {FileChanged, "file-changed", TR("the file has changed since the project was saved"),
     TR("Check that the cuts, eases and positions still fit"), true},
    {PieceGone, "piece-gone",
     TR("the garment no longer has this piece, so its settings are not used"),
     TR("Apply the settings to another piece if you need them"), true},
    {EdgesCrowd, "edges-crowd",
     TR("too many outline edges lie together, so no seams are found there"),
     TR("Check the unit, and the mesh at these places"), true},
    {ReadAs, "read-as", TR("the file is not a plain sheet of cloth, so it was converted to one"),
     TR("Choose another kind of input if this is wrong"), true, "--as sheet"},
    {CannotReadAs, "cannot-read-as",
     TR("the file does not fit the chosen kind of input, so it was not converted"),
     TR("Choose another kind of input"), false, "--as sheet"},
    {LooksLikeScan, "looks-like-scan", TR("the file looks like a scan"),
     TR("Prepare it as a scan to remove debris, close holes and smooth noise"), true, "--as scan"},
    {EdgesCollapsed, "edges-collapsed", TR("edges have no length, so their ends are merged"), "",
     true},
    {FlatFacesRemoved, "flat-faces-removed",
     TR("triangles without area are removed where possible"), "", true},
    {DuplicateFacesRemoved, "duplicate-faces-removed", TR("duplicate faces are removed"), "", true},
    {WindingsTurned, "windings-turned",
     TR("faces are flipped to match the larger area around them"), "", true},
    {EdgesCutApart, "edges-cut-apart", TR("edges shared by more than two faces are cut apart"),
     TR("Check that the right faces stay joined there"), true},
    {VerticesSplit, "vertices-split", TR("parts that touch at a single vertex are separated"), "",
     true},
    {VerticesAdded, "vertices-added",
     TR("different edges join the same two vertices, so vertices are added"), "", true},
    {VerticesWelded, "vertices-welded", TR("vertices at the same position are merged"), "", true},
    {HolesKept, "holes-kept", TR("the piece has holes inside its outline, which stay open"),
     TR("Use the isometric method if the lengths of their rims matter"), true},
    {OutlineCrosses, "outline-crosses", TR("the flat outline crosses itself"),
     TR("Add a cut to the piece before you cut cloth"), true},
    {OutlineUncrossed, "outline-uncrossed",
     TR("the flat outline crossed itself, so it was moved apart without changing its lengths"), "",
     true},
    {TrianglesFlipped, "triangles-flipped",
     TR("triangles are flipped or have no area in the pattern"),
     TR("Choose another method, or cut the piece where it curves most"), true},
    {EdgesTooShort, "edges-too-short", TR("boundary edges are too short for exact lengths"),
     TR("Check the piece for doubled vertices and extreme coordinates"), true},
    {DegenerateTriangles, "degenerate-triangles",
     TR("triangles have almost no height, so the pattern may be uneven there"),
     TR("Merge doubled vertices or remove slivers in the modelling program"), true},
    {AnglesOutOfRange, "angles-out-of-range",
     TR("the surface's curvature needs corners that no flat outline can have"),
     TR("Cut the piece where it curves most if the pattern looks folded there"), true},
    {EndedEarly, "ended-early", TR("the method stopped before it converged"),
     TR("Check the strain before you cut cloth; remove slivers, or cut the piece where it curves "
        "most"),
     true},
    {RimsNotKept, "rims-not-kept", TR("the rims of holes differ in length from the garment"),
     TR("Cut from the rim to the outline if you want to sew in a patch"), true},
    {LineNotDrawn, "line-not-drawn",
     TR("the outline could not be drawn as a fair line, so it is exact"),
     TR("Lower the tolerance, remove straight lines and typed intakes, or refine the mesh along "
        "the outline"),
     true},
    {LineYields, "line-yields",
     TR("the fair line would cross itself, so it stays closer to the exact outline there"),
     TR("Cut the piece, or give its edges more room"), true},
    {LeftOut, "left-out", TR("the piece is left out of the pattern"), "", true},
    {ClosedSurface, "closed-surface", TR("the piece is closed and has no outline"),
     TR("Cut it open along a seam, or let Toile do it"), false, "--auto-cut"},
    {SeveralLoops, "several-loops", TR("the piece has several boundary loops"),
     TR("Cut it from loop to loop, or let Toile do it"), false, "--auto-cut"},
    {Handle, "handle", TR("the piece has a handle, like a ring or a cup"),
     TR("Cut the handle open along a seam, or let Toile do it"), false, "--auto-cut"},
    {NonManifoldEdge, "non-manifold-edge", TR("edges are shared by more than two faces"),
     TR("Separate the layers that meet there")},
    {NonManifoldVertex, "non-manifold-vertex", TR("parts of the piece touch at a single vertex"),
     TR("Separate the parts, or join them along an edge")},
    {OpposedWinding, "opposed-winding", TR("neighbouring faces point in opposite directions"),
     TR("Make the normals consistent in the modelling program")},
    {NotOrientable, "not-orientable", TR("the piece has only one side, like a Moebius strip"),
     TR("Cut it across")},
    {DuplicateFace, "duplicate-face", TR("the piece has duplicate faces"),
     TR("Remove the duplicate faces in the modelling program")},
    {DegenerateFace, "degenerate-face", TR("triangles have no area"),
     TR("Merge doubled vertices or remove slivers in the modelling program")},
    {ZeroLengthEdge, "zero-length-edge", TR("boundary edges have no length"),
     TR("Merge the doubled vertices in the modelling program")},
    {CutImpossible, "cut-impossible", TR("the cut cannot be made"),
     TR("Move its points, or repair the piece first")},
    {NoBodySeen, "no-body-seen",
     TR("the piece does not look like a garment on a body, so it gets the shortest cuts"),
     TR("Draw your own cuts if you want them elsewhere"), true},
    {JoinImpossible, "join-impossible", TR("the seam cannot be removed"),
     TR("Keep it, or join the parts in the modelling program")},
    {NoSuchSeam, "no-such-seam", TR("the garment has no seam of this name"),
     TR("Check the names in the list of seams"), false, "toile info lists them"},
    {NoClosedOutline, "no-closed-outline",
     TR("one boundary edge is as long as all others together, so no flat outline can close"),
     TR("Refine the boundary, or move the seam")},
    {BoundaryNotConverged, "boundary-not-converged",
     TR("the solver found no closed outline near the surface's angles"),
     TR("Cut the piece where it curves most, or choose the other boundary solver")},
    {OutlineNotHeld, "outline-not-held",
     TR("the moved outline cannot be filled without flipped triangles"),
     TR("Move the outline less, or refine the mesh along it")},
    {FactorisationFailed, "factorisation-failed",
     TR("the equations of the interior could not be solved"),
     TR("Check the piece for slivers and extreme differences in edge length")},
    {NotFinite, "not-finite", TR("the result is not a finite number"),
     TR("Check the piece for extreme coordinates")},
    {OutOfMemory, "out-of-memory", TR("there is not enough memory"),
     TR("Close other programs, or flatten fewer or coarser pieces at a time")},
    {Cancelled, "cancelled", TR("cancelled"), ""},
    {SeamsByNearness, "seams-by-nearness",
     TR("seams are guessed from edges that lie close together but share no points"),
     TR("Check them in the list of seams"), true},
    {LineStrays, "line-strays",
     TR("the garment is wrinkled, so its fair lines are less exact than usual"),
     TR("Lower the tolerance of fair lines to keep them closer, with more waves"), true},
};

static_assert(std::size(kWords) == kErrorCodeCount &&
              std::ranges::is_sorted(kWords, std::less_equal<>(), &Words::code));

const Words& wordsOf(ErrorCode code) {
    return kWords[static_cast<std::size_t>(code)];
}

}  // namespace

Problems aboutEach(ErrorCode code, const std::vector<Subject>& subjects, const Wording& detail) {
    constexpr std::size_t kFew = 10, kNamed = 3;
    Problems problems;
    std::vector<std::string> names;
    for (const Subject& subject : subjects) {
        problems.push_back({code, subject, detail});
        names.push_back(subject.name);
    }
    if (subjects.size() > kFew) {
        return {{code, {subjects.front().kind, 0, quotedList(names, kNamed)}, detail}};
    }
    return problems;
}

std::string_view name(ErrorCode code) {
    return wordsOf(code).name;
}

std::string_view describe(ErrorCode code) {
    return wordsOf(code).describe;
}

std::string_view advice(ErrorCode code) {
    return wordsOf(code).advice;
}

std::string_view commandLineOption(ErrorCode code) {
    return wordsOf(code).option;
}

bool isNote(ErrorCode code) {
    return wordsOf(code).note;
}

std::string sentence(const Error& error) {
    const Words& words = wordsOf(error.code);
    std::string text;
    if (!error.subject.name.empty()) {
        text += shownText(error.subject.name, kMaxOfPlace) + ": ";
    }
    text += words.describe;
    if (!error.detail.empty()) {
        text += " (" + shownText(error.detail, kMaxOfDetail) + ")";
    }
    if (!words.advice.empty()) {
        text += ". ";
        text += words.advice;
    }
    if (!words.option.empty()) {
        text += " (" + std::string(words.option) + ")";
    }
    return text + ".";
}

namespace {

constexpr std::string_view kBare = "%1, %2, %3", kInBrackets = "(%1, %2, %3)";
constexpr std::string_view kUnit = " mm";

/// The value with all its digits. If it is written in scientific form or as "0.0", the written
/// value, which has no sign in "0.0".
double valueOf(const Wording& figure) {
    double written = std::numeric_limits<double>::quiet_NaN();
    std::from_chars(figure.data(), figure.data() + figure.size(), written);
    return figure.decimals() < 0 || written == 0 ? written : figure.value();
}

std::optional<std::array<double, 3>> placeOf(const Wording& wording) {
    std::array<double, 3> place{};
    const std::string_view pattern = wording.pattern() ? wording.pattern() : "";
    if ((pattern != kInBrackets && pattern != kBare) ||
        wording.arguments().size() != place.size()) {
        return std::nullopt;
    }
    std::ranges::transform(wording.arguments(), place.begin(), valueOf);
    const bool isSomewhere = std::ranges::all_of(place, [](double x) { return std::isfinite(x); });
    return isSomewhere ? std::optional(place) : std::nullopt;
}

void collectPlaces(const Wording& wording, std::string_view after,
                   std::vector<PlaceInText>& places) {
    if (const auto place = placeOf(wording)) {
        places.push_back({wording + std::string(after.starts_with(kUnit) ? kUnit : ""), *place});
        return;
    }
    std::string_view rest = wording.pattern() ? wording.pattern() : "";
    for (std::size_t at = rest.find('%'); at != std::string_view::npos; at = rest.find('%')) {
        rest.remove_prefix(at + 1);
        if (!rest.empty() && std::isdigit(static_cast<unsigned char>(rest.front())) != 0) {
            const auto argument = static_cast<std::size_t>(rest.front() - '1');
            rest.remove_prefix(1);
            collectPlaces(wording.arguments().at(argument), rest, places);
        }
    }
}

}  // namespace

Wording barePlaceWording(double x, double y, double z) {
    return worded("%1, %2, %3", {figure(x, 1), figure(y, 1), figure(z, 1)});
}

std::vector<PlaceInText> placesIn(const Error& error) {
    std::vector<PlaceInText> places;
    collectPlaces(error.detail, {}, places);
    const std::string shown = shownText(error.detail, kMaxOfDetail);  // as `sentence` shows it
    std::size_t from = 0;
    const auto lost = std::ranges::find_if(places, [&](const PlaceInText& place) {
        const std::size_t found = shown.find(place.words, from);
        from = found + place.words.size();
        return found == std::string::npos;
    });
    places.erase(lost, places.end());
    return places;
}

}  // namespace toile
