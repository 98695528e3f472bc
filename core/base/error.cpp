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
     TR("Check that the folder exists, is writable and has room")},
    {UnknownFormat, "unknown-format", TR("the file's ending names no format Toile knows"),
     TR("Export the garment as .obj"), false, "toile flatten --help lists the formats"},
    {FormatNotBuilt, "format-not-built", TR("this build of Toile does not write the format"),
     TR("Use one that has the window")},
    {NotReadBack, "not-read-back", TR("the file made says something else than the pattern"),
     TR("Nothing was written; use another format and report this with the garment")},
    {PageTooSmall, "page-too-small", TR("the pattern does not fit the page"),
     TR("Choose other paper, or lay the pieces closer together")},
    {MalformedFile, "malformed-file", TR("the file breaks the rules of its format"),
     TR("Export it again from the program it came from")},
    {NoGeometry, "no-geometry", TR("the file holds no faces"),
     TR("Export the garment as a mesh with faces")},
    {MalformedProject, "malformed-project", TR("the project file breaks the rules of its format"),
     TR("Open an older copy of it, or correct the place named with a text editor")},
    {NewerProject, "newer-project", TR("the project was saved by a newer version of Toile"),
     TR("Open it with that version")},
    {UnitGuessed, "unit-guessed", TR("the size leaves doubt about the unit"),
     TR("State the unit if the size is wrong"), true},
    {IndexOutOfRange, "index-out-of-range", TR("faces name vertices that the file does not have"),
     TR("They are left out; export the file again if something is missing"), true},
    {NonFinitePosition, "non-finite-position", TR("positions are not finite numbers"),
     TR("Faces on them are left out; export the file again if something is missing"), true},
    {DegenerateFaceRecord, "degenerate-face-record",
     TR("faces have fewer than three different corners"), TR("They are left out"), true},
    {PolygonNotSimple, "polygon-not-simple", TR("polygons could not be divided by their shape"),
     TR("They are divided as a fan, which may fold over; triangulate them in the "
        "modelling program"),
     true},
    {UnusedVertices, "unused-vertices", TR("vertices belong to no face"), "", true},
    {OutputDiffers, "output-differs", TR("a mesh written from this file differs from it"), "",
     true},
    {UnknownKey, "unknown-key", TR("the file says things that this Toile does not know"),
     TR("They do nothing, and are gone once the project is saved here; look for a "
        "misspelt name"),
     true},
    {FileChanged, "file-changed", TR("the file is not as it was when the project was saved"),
     TR("Cuts, ease and places are kept; look whether they still fit"), true},
    {PieceGone, "piece-gone", TR("the garment has no piece of this name any more"),
     TR("What the project says of it is left out"), true},
    {EdgesCrowd, "edges-crowd", TR("the edges of outlines crowd as those of no garment do"),
     TR("Seams are not looked for there"), true},
    {ReadAs, "read-as", TR("the file is no plain sheet of cloth and was made one"),
     TR("Say what the file is if that is wrong"), true, "--as sheet"},
    {CannotReadAs, "cannot-read-as", TR("the file does not look like the stated kind"),
     TR("Nothing was done with it; say that it is something else"), false, "--as sheet"},
    {LooksLikeScan, "looks-like-scan", TR("the file looks like a scan"),
     TR("Prepare it as a scan: debris is removed, holes are closed, noise is smoothed"), true,
     "--as scan"},
    {EdgesCollapsed, "edges-collapsed", TR("edges have no length"),
     TR("Their two ends are made one vertex"), true},
    {FlatFacesRemoved, "flat-faces-removed", TR("triangles have no area"),
     TR("They are removed so that no hole opens"), true},
    {DuplicateFacesRemoved, "duplicate-faces-removed", TR("faces lie twice on the same vertices"),
     TR("One of each is kept"), true},
    {WindingsTurned, "windings-turned", TR("faces look to the other side than their neighbours"),
     TR("They are flipped to agree with the larger area"), true},
    {EdgesCutApart, "edges-cut-apart", TR("edges are shared by more than two faces"),
     TR("The faces that continue each other best stay joined; the others are cut free"), true},
    {VerticesSplit, "vertices-split", TR("parts of the surface touch in a single vertex"),
     TR("Each part gets a vertex of its own"), true},
    {VerticesAdded, "vertices-added",
     TR("different edges of the surface join the same two vertices"),
     TR("All but one of them get a vertex in their middle"), true},
    {VerticesWelded, "vertices-welded", TR("vertices lie on each other without being joined"),
     TR("They are made one"), true},
    {HolesKept, "holes-kept", TR("holes in the cloth stay open inside the outline"),
     TR("The isometric method keeps the lengths of their rims; the others measure "
        "them only"),
     true},
    {OutlineCrosses, "outline-crosses", TR("the flat outline crosses itself"),
     TR("Divide the piece by a cut before it is cut out of cloth"), true},
    {OutlineUncrossed, "outline-uncrossed",
     TR("the flat outline crossed itself and was moved apart, keeping its lengths"), "", true},
    {TrianglesFlipped, "triangles-flipped",
     TR("triangles are flipped or without area in the pattern"),
     TR("Choose another method, or cut the piece where it curves most"), true},
    {EdgesTooShort, "edges-too-short",
     TR("boundary edges are too short for their lengths to be exact"),
     TR("Look for doubled vertices and extreme coordinates in the piece"), true},
    {DegenerateTriangles, "degenerate-triangles", TR("triangles have almost no height"),
     TR("The pattern may be uneven next to them; merge doubled vertices or remove the "
        "slivers in the modelling program"),
     true},
    {AnglesOutOfRange, "angles-out-of-range",
     TR("the surface's curvature asks for corners that no flat outline has"),
     TR("Cut the piece where it curves most if the pattern looks folded there"), true},
    {EndedEarly, "ended-early", TR("the method ended before it reached its goal"),
     TR("Look at its strain before you cut cloth; look for slivers in the piece, or cut it "
        "where it curves most"),
     true},
    {RimsNotKept, "rims-not-kept", TR("the rims of holes are not as long as on the garment"),
     TR("Cut from the rim to the outline if a patch is to be sewn in"), true},
    {LineNotDrawn, "line-not-drawn",
     TR("the outline could not be drawn as a fair line, and is exact"),
     TR("Allow it to stray less, take straight lines and typed intakes back, or refine the mesh "
        "along it"),
     true},
    {LineYields, "line-yields", TR("the fair line would cross itself"),
     TR("There it stays nearer to the exact outline, and is less smooth; cut the piece, or give "
        "its "
        "edges more room"),
     true},
    {LeftOut, "left-out", TR("the piece is left out of the pattern"), "", true},
    {ClosedSurface, "closed-surface", TR("the piece is closed and has no outline"),
     TR("Cut it open along a seam, or let Toile do it"), false, "--auto-cut"},
    {SeveralLoops, "several-loops", TR("the piece has several boundary loops"),
     TR("Cut it from loop to loop, or let Toile do it"), false, "--auto-cut"},
    {Handle, "handle", TR("the piece has a handle, like a ring or a cup"),
     TR("Cut the handle open along a seam, or let Toile do it"), false, "--auto-cut"},
    {NonManifoldEdge, "non-manifold-edge", TR("edges are shared by more than two faces"),
     TR("Separate the layers that meet there")},
    {NonManifoldVertex, "non-manifold-vertex", TR("parts of the piece touch in a single vertex"),
     TR("Separate the parts, or join them along an edge")},
    {OpposedWinding, "opposed-winding", TR("neighbouring faces look to opposite sides"),
     TR("Make the normals consistent in the modelling program")},
    {NotOrientable, "not-orientable", TR("the piece has one side only, like a Moebius strip"),
     TR("Cut it across")},
    {DuplicateFace, "duplicate-face", TR("faces lie twice on the same vertices"),
     TR("Remove the doubled faces in the modelling program")},
    {DegenerateFace, "degenerate-face", TR("triangles have no area"),
     TR("Merge doubled vertices or remove the slivers in the modelling program")},
    {ZeroLengthEdge, "zero-length-edge", TR("boundary edges have no length"),
     TR("Merge the doubled vertices in the modelling program")},
    {CutImpossible, "cut-impossible", TR("the cut cannot be made"),
     TR("Move its points, or repair the piece first")},
    {NoBodySeen, "no-body-seen", TR("the piece is not seen to be a garment that is worn"),
     TR("It gets the shortest cuts that let it lie flat; draw others where they are wanted"), true},
    {JoinImpossible, "join-impossible", TR("the seam cannot be taken out"),
     TR("Leave it, or join the parts in the modelling program")},
    {NoSuchSeam, "no-such-seam", TR("the garment has no seam of this name"),
     TR("Look at the names in the list of seams"), false, "toile info lists them"},
    {NoClosedOutline, "no-closed-outline",
     TR("one boundary edge is as long as all the others together, so that no flat "
        "outline has these lengths"),
     TR("Refine the boundary or move the seam")},
    {BoundaryNotConverged, "boundary-not-converged",
     TR("no closed outline near the surface's angles was found"),
     TR("Cut the piece where it curves most, or choose the other boundary solver")},
    {OutlineNotHeld, "outline-not-held",
     TR("no interior without flipped triangles fits the outline as it was moved"),
     TR("Move the outline by less, or refine the mesh along it")},
    {FactorisationFailed, "factorisation-failed",
     TR("the interior's equations could not be solved"),
     TR("Look for slivers and extreme differences of edge length in the piece")},
    {NotFinite, "not-finite", TR("the result is not a finite number"),
     TR("Look for extreme coordinates in the piece")},
    {OutOfMemory, "out-of-memory", TR("there is not enough memory"),
     TR("Close other programs, or flatten fewer or coarser pieces at a time")},
    {Cancelled, "cancelled", TR("cancelled"), ""},
    {SeamsByNearness, "seams-by-nearness",
     TR("seams are guessed: their edges lie near each other, but have no points in common"),
     TR("Check them in the list of seams"), true},
    {LineStrays, "line-strays",
     TR("the garment is wrinkled, and the fair line strays further than usual"),
     TR("Set another tolerance for fair lines to keep it nearer, with more waves"), true},
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
        text += "; ";
        text += lowered(words.advice.front());
        text += words.advice.substr(1);
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
