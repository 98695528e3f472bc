// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <filesystem>
#include <iosfwd>
#include <map>
#include <numbers>
#include <ostream>

#include "app/cli/command_line.h"
#include "core/assemble/cut_pieces.h"
#include "core/assemble/slits.h"
#include "core/base/characters.h"
#include "core/base/file.h"
#include "core/base/text.h"
#include "core/diagnose/doubt.h"
#include "core/formats/pattern_file.h"
#include "core/formats/read_pattern.h"
#include "core/formats/writers.h"
#include "core/garment/garment.h"
#include "core/geometry/polygon.h"
#include "core/io/assimp_reader.h"
#include "core/project/layer_materials.h"
#include "core/seam/seam_measure.h"
#include "core/tailor/mesh_lines.h"
#include "core/toile/pipeline.h"

namespace toile::app {
namespace {

std::string percent(double part) {
    return fixed(100 * part, part < 0.01 ? 2 : 1);
}

std::string textOf(const std::optional<DartIntake>& intake) {
    return intake ? fixed(intake->width, 0) + " mm, " +
                        fixed(intake->angle * 180 / std::numbers::pi, 0) + " deg"
                  : "";
}

std::vector<UserCut> ownCutsOf(const Garment& garment, const std::shared_ptr<const Piece>& piece) {
    const auto record = std::ranges::find(garment.cutRecords, piece, &CutRecord::whole);
    return record == garment.cutRecords.end() ? std::vector<UserCut>{} : record->requested;
}

/// Seconds after which advice reports each flattening, and does no more of them.
constexpr double kLongAdvice = 5, kMaxAdvice = 60;

void printFor(const std::shared_ptr<const Piece>& piece, const std::vector<UserCut>& own,
              const PolygonSoup& soup, const Arguments& arguments, const Stopwatch& watch,
              Progress& progress, std::ostream& out, Messages& messages) {
    const CutAdvice advice = adviseCuts(
        piece, own,
        {arguments.load.isFrontSwapped, arguments.load.enoughStrain, fileBorders(*piece, soup)},
        progress);
    out << piece->name << ": ";
    if (advice.cuts.empty()) {
        out << "no cut reduces the strain enough for its length\n\n";
        return;
    }
    const auto solvedAfter = [&](std::size_t count) {
        if (watch.seconds() > kMaxAdvice) {
            return std::string("-");
        }
        if (watch.seconds() > kLongAdvice) {
            messages.add(fixed(watch.seconds(), 0) + " s: flattening " + shownText(piece->name) +
                         " with " + counted(static_cast<long long>(count), "more cut"));
        }
        const auto solved = solvedStrain(piece, own, advice, count, arguments.options, progress);
        return solved ? percent(solved->mean) : std::string("-");
    };
    out << "strain " << percent(advice.before.mean) << " % predicted, " << solvedAfter(0)
        << " % solved with the fewest cuts; these cuts reduce it, best first\n";
    Table table(
        {"cut", "length mm", "in all mm", "strain %", "solved %", "takes in", "enough", "because"});
    double inAll = 0;
    for (std::size_t k = 0; k < advice.cuts.size(); ++k) {
        const AdvisedCut& cut = advice.cuts[k];
        inAll += cut.length;
        table.add({cut.what.cut.name, fixed(cut.length, 0), fixed(inAll, 0),
                   percent(cut.predicted.mean), k < kSolvedAhead ? solvedAfter(k + 1) : "",
                   textOf(cut.intake), cut.isNeeded ? "yes" : "", cut.evidence});
    }
    table.print(out);
    out << '\n';
}

/// For each piece before Toile's own cuts, prints the cuts that reduce strain most and the
/// remaining strain: predicted for all, computed for the best five.
/// Cost: that of `adviseCuts`, and six flattenings of each piece, but no more after a minute.
void printAdvice(const Arguments& arguments, const Garment& garment, Progress& progress,
                 std::ostream& out, Messages& messages) {
    const Stopwatch watch;
    for (const auto& piece : garment.uncut) {
        if (piece->defect && !isOpenable(*piece)) {
            out << piece->name << ": cuts do not help because " << describe(piece->defect->code)
                << "\n\n";
            continue;
        }
        printFor(piece, ownCutsOf(garment, piece),
                 *garment.files[static_cast<std::size_t>(piece->file)]->soup, arguments, watch,
                 progress, out, messages);
    }
    if (watch.seconds() > kMaxAdvice) {
        messages.add("the strain of the remaining cuts is only predicted: flattening took " +
                     fixed(kMaxAdvice, 0) + " s. Use a coarser mesh to have all solved.");
    }
}

constexpr double kSquareMillimetresPerSquareCm = 100;
constexpr std::size_t kSizesListed = 20;

std::string outlineFigures(const Points2& line) {
    return line.rows() == 0 ? "-" : fixed(geometry::perimeterOf(line), 1);
}

std::string quantityOf(const FilePiece& piece) {
    return piece.mirroredQuantity > 0 ? std::to_string(piece.quantity) + " + " +
                                            std::to_string(piece.mirroredQuantity) + " mirrored"
                                      : std::to_string(piece.quantity);
}

void printPieces(const PatternFile& file, std::ostream& out) {
    Table table({"piece", "size", "cut", "cut line mm", "seam line mm", "area cm2", "points",
                 "holes", "lines", "notches", "drills", "half", "material"});
    for (const FilePiece& piece : file.pieces) {
        const Points2& outline = outlineOf(piece);
        table.add({piece.name, piece.size, quantityOf(piece), outlineFigures(piece.cut),
                   outlineFigures(piece.sew),
                   fixed(geometry::signedAreaOf(outline) / kSquareMillimetresPerSquareCm, 1),
                   std::to_string(outline.rows()), std::to_string(piece.holes.size()),
                   std::to_string(piece.internals.size()), std::to_string(piece.notches.size()),
                   std::to_string(piece.drills.size()), piece.isUnfolded ? "unfolded" : "",
                   piece.material});
    }
    table.print(out);
}

void printLayers(const PatternFile& file, std::ostream& out) {
    std::map<std::string, int> layers;
    for (const FilePiece& piece : file.pieces) {
        for (const auto& [layer, count] : piece.layers) {
            layers[layer] += count;
        }
    }
    if (layers.empty()) {
        return;
    }
    out << "layers:";
    const char* joint = " ";
    for (const auto& [layer, count] : layers) {
        out << joint << (layer.empty() ? "-" : shownText(layer)) << " ("
            << (count == 1 ? "1 entity" : std::to_string(count) + " entities") << ")";
        joint = ", ";
    }
    out << '\n';
}

void printHead(const std::filesystem::path& path, const PatternFile& file, std::ostream& out) {
    out << shownText(path.string(), kMaxOfPlace) << ": " << file.format << ", "
        << counted(static_cast<long long>(file.pieces.size()), "piece") << ", unit "
        << unitText(file.unit);
    if (!file.unitReason.empty()) {
        out << " (" << file.unitReason << (file.unitInDoubt ? "; uncertain" : "") << ")";
    }
    out << '\n';
    if (!file.style.empty()) {
        out << "style: " << shownText(file.style) << '\n';
    }
    if (!file.sizes.empty()) {
        out << counted(static_cast<long long>(file.sizes.size()), "size") << ": ";
        for (std::size_t k = 0; k < std::min(file.sizes.size(), kSizesListed); ++k) {
            out << (k == 0 ? "" : ", ") << shownText(file.sizes[k]);
        }
        out << (file.sizes.size() > kSizesListed ? ", ..." : "");
        if (!file.sampleSize.empty()) {
            out << "; sample size " << shownText(file.sampleSize);
        }
        out << '\n';
    }
}

/// Whether a file is a pattern instead of a garment, by its extension.
bool isPatternFile(const std::filesystem::path& path) {
    return patternFileKind(path).has_value();
}

/// `toile info` of pattern files: pieces, sizes, layers, lengths, and the source of the unit.
/// @return the exit status
int runPatternInfo(const Arguments& arguments, std::ostream& out, Messages& messages) {
    int status = kExitDone;
    for (const std::filesystem::path& path : arguments.inputs) {
        const auto file = readPatternFile(path, arguments.load.unit);
        if (!file) {
            messages.add(file.error());
            status = kExitUnreadable;
            continue;
        }
        if (arguments.json) {
            out << writePatternFile(*file);
            continue;
        }
        printHead(path, *file, out);
        printLayers(*file, out);
        out << '\n';
        printPieces(*file, out);
        reportPatternNotes(path, *file, messages);
    }
    out.flush();
    return out ? status : kExitUnreadable;
}

/// Warns if rounding the coordinates to floats matters: far from the origin, or in a small unit.
void printPrecision(const SourceFile& file, std::ostream& out) {
    constexpr double kTelling = 0.001;  // mm
    const double precision = file.unit.millimetres() * precisionOfFloats(*file.soup);
    if (isForAssimp(pathText(file.path.extension())) && precision > kTelling) {
        out << "coordinates are precise only to " << fixed(precision, 3)
            << " mm (single precision); use OBJ, or move the garment to the origin\n";
    }
}

/// The kind of the input: "a thick shell (two surfaces 1.5 mm apart)".
void printReading(const FileReading& reading, std::ostream& out) {
    static constexpr Word<FileKind> kShown[] = {
        {FileKind::Sheet, "a plain sheet"},
        {FileKind::Shell, "a thick shell"},
        {FileKind::Scan, "a scan"},
        {FileKind::Layers, "layers of cloth"},
        {FileKind::Solid, "a solid, to be covered"},
        {FileKind::Soup, "unconnected triangles, joined"},
    };
    out << (reading.isStated ? "read as " : "taken for ") << wordOf(kShown, reading.kind);
    if (!reading.evidence.empty()) {
        out << " (" << reading.evidence << ")";
    }
    if (reading.leftOut.F.rows() > 0) {
        out << ", " << counted(reading.leftOut.F.rows(), "triangle") << " left out";
    }
    if (reading.kind == FileKind::Solid) {
        out << "; use --auto-cut to cut it open";
    }
    if (reading.half) {
        out << (reading.half->isCompleted
                    ? ", with the mirror image added to it"
                    : "; it looks like half a garment: " + fixed(reading.half->length, 0) +
                          " mm of its rims lie in one plane; use "
                          "--complete-half to add the other half");
    }
    out << '\n';
}

/// Prints which side the faces show: the right side of the cloth.
void printSide(const ClothSide& side, std::ostream& out) {
    out << "right side: "
        << (side.way == ClothSide::Way::Inwards    ? "inwards, so pieces come out mirrored"
            : side.way == ClothSide::Way::Outwards ? "outwards"
                                                   : "as the faces are wound");
    if (!side.evidence.empty()) {
        out << " (" << side.evidence << ")";
    }
    out << (side.way == ClothSide::Way::Inwards ? "; use --turn-over to turn it\n" : "\n");
}

/// Prints the number of pieces in each layer of a file.
void printLayers(const Garment& garment, int file, std::ostream& out) {
    const std::vector<int> layers = layersOf(garment);
    std::vector<int> pieces(static_cast<std::size_t>(layerCount(garment.files[file]->reading)), 0);
    for (std::size_t p = 0; p < layers.size(); ++p) {
        pieces[layers[p]] += garment.pieces[p]->file == file ? 1 : 0;
    }
    for (std::size_t k = 0; pieces.size() > 1 && k < pieces.size(); ++k) {
        out << "layer " << k + 1 << (k == 0 ? ", the outermost" : "") << ": "
            << counted(pieces[k], "piece") << (k + 1 == pieces.size() ? "\n" : "; ");
    }
}

void printFile(const SourceFile& file, std::ostream& out) {
    out << shownText(file.path.string(), kMaxOfPlace) << ": "
        << counted(file.soup->faceCount(), "face") << ", "
        << counted(static_cast<long long>(file.soup->positions.size()), "vertex") << ", unit "
        << unitText(file.unit);
    if (!file.unitReason.empty()) {
        out << " (" << file.unitReason << ")";
    }
    out << ", up " << name(file.up);
    if (!file.upReason.empty()) {
        out << " (" << file.upReason << ")";
    }
    out << ", divided by " << name(file.split.mode);
    if (!file.split.reason.empty()) {
        out << " (" << file.split.reason << ")";
    }
    out << '\n';
    printReading(file.reading, out);
    printSide(file.side, out);
    printPrecision(file, out);
    if (const auto& better = file.betterSplit) {
        out << better->flat << " of " << counted(better->pieces, "piece")
            << " could lie flat uncut with --split " << name(better->mode) << '\n';
    }
}

/// The lengths of the longest loops, including the outline.
std::string loopsOf(const Piece& piece) {
    constexpr std::size_t kListed = 3;
    std::vector<double> lengths = loopLengths(piece);
    std::sort(lengths.rbegin(), lengths.rend());
    std::string text = std::to_string(lengths.size());
    for (std::size_t k = 0; k < std::min(lengths.size(), kListed); ++k) {
        text += (k == 0 ? ": " : ", ") + fixed(lengths[k], 0);
    }
    return lengths.size() > kListed ? text + ", ..." : text;
}

std::vector<std::string> rowOf(const Piece& piece) {
    const auto size =
        (piece.mesh.V.colwise().maxCoeff() - piece.mesh.V.colwise().minCoeff()).eval();
    const std::string holes =
        piece.holes.empty() ? ""
                            : ", " + counted(static_cast<long long>(piece.holes.size()), "hole");
    return {piece.name,
            std::to_string(piece.mesh.V.rows()),
            std::to_string(piece.mesh.F.rows()),
            loopsOf(piece),
            fixed(size.x(), 0) + " x " + fixed(size.y(), 0) + " x " + fixed(size.z(), 0),
            piece.defect ? std::string(name(piece.defect->code)) : "disk" + holes};
}

void printPieces(const Garment& garment, std::ostream& out) {
    Table table({"piece", "vertices", "triangles", "loops mm", "size mm", "kind"});
    for (const auto& piece : garment.pieces) {
        table.add(rowOf(*piece));
    }
    table.print(out);
}

/// Prints slits inside pieces, which are common in UV maps, and the option that closes them.
void printSlits(const Arguments& arguments, const Garment& garment, std::ostream& out) {
    const std::vector<Slit> slits = slitsInside(garment.pieces);
    if (!slits.empty()) {
        double length = 0;
        for (const Slit& slit : slits) {
            length += slit.length;
        }
        // Exclude slits from cuts. A project defines how its files are read, so the option has no
        // effect.
        const bool canClose =
            !arguments.load.closeSlits && !arguments.project && !slitsInside(garment.uncut).empty();
        out << '\n'
            << counted(static_cast<long long>(slits.size()), "slit") << " inside pieces, "
            << fixed(length, 0) << " mm in all, whose edges lie on each other"
            << (canClose ? "; use --close-slits to close them" : "") << '\n';
    }
}

void printSeams(const Garment& garment, std::ostream& out) {
    if (garment.seams.seams.empty()) {
        return;
    }
    Table table({"seam", "kind", "left mm", "right mm", "ease %"});
    for (const Seam& seam : garment.seams.seams) {
        const bool sewn = seam.right.piece >= 0;
        table.add({seam.name, std::string(name(seam.kind)), fixed(seam.length3d[0], 1),
                   sewn ? fixed(seam.length3d[1], 1) : "-",
                   sewn ? fixed(100 * easeOf(seam), 1) : "-"});
    }
    out << '\n';
    table.print(out);
}

/// Whether the piece is named after an object, group or material of the file.
bool isNamedInFile(const Piece& piece, const Garment& garment) {
    const PolygonSoup& soup = *garment.files[static_cast<std::size_t>(piece.file)]->soup;
    const auto isOf = [&piece](const std::vector<int>& ofFace,
                               const std::vector<std::string>& names) {
        return std::ranges::any_of(piece.sourceFace, [&](int face) {
            const int k = face < 0 || ofFace.empty() ? -1 : ofFace[face];
            return k >= 0 && !names[k].empty() && piece.name.find(names[k]) != std::string::npos;
        });
    };
    return isOf(soup.faceObject, soup.objects) || isOf(soup.faceGroup, soup.groups) ||
           isOf(soup.faceMaterial, soup.materials);
}

/// Prints the assumptions about the pieces (docs/guesses.md).
void printAssumptions(const Garment& garment, std::ostream& out) {
    constexpr double kShared = 1e-6;  // mm: the sides of the seam have the same vertices
    int shared = 0, near = 0, free = 0;
    double widest = 0;
    for (const Seam& seam : garment.seams.seams) {
        const bool isFree = seam.kind == SeamKind::Free;
        free += isFree ? 1 : 0;
        shared += !isFree && seam.gap <= kShared ? 1 : 0;
        near += !isFree && seam.gap > kShared ? 1 : 0;
        widest = std::max(widest, seam.gap);
    }
    const auto named = std::ranges::count_if(
        garment.pieces, [&garment](const auto& piece) { return isNamedInFile(*piece, garment); });
    out << "\nassumptions that you can change (docs/guesses.md):\n"
        << "seams: " << shared << " along common vertices, " << near << " by nearness";
    if (near > 0) {
        out << ", up to " << fixed(widest, 2) << " mm apart on average";
    }
    out << "\nedges: " << free << " not sewn, treated as hems where allowances are drawn\n"
        << "grain: up the garment\n"
        << "names: " << named << " of " << garment.pieces.size()
        << " from the file, the others invented\n"
        << "left and right: as in the file, except with --mirror and --pattern\n";
}

}  // namespace

int runInfo(const Arguments& arguments, std::ostream& out, Messages& messages) {
    if (std::ranges::all_of(arguments.inputs, isPatternFile)) {
        return runPatternInfo(arguments, out, messages);
    }
    Progress progress;
    const auto garment = readInput(arguments, progress, messages);
    if (!garment) {
        return kExitUnreadable;
    }
    if (arguments.json) {
        out << writeInfo(*garment);
    } else {
        for (std::size_t k = 0; k < garment->files.size(); ++k) {
            printFile(*garment->files[k], out);
            printLayers(*garment, static_cast<int>(k), out);
        }
        out << '\n';
        printCuts(*garment, out);
        printPieces(*garment, out);
        printSlits(arguments, *garment, out);
        printSeams(*garment, out);
        printAssumptions(*garment, out);
        if (arguments.advice) {
            out << '\n';
            printAdvice(arguments, *garment, progress, out, messages);
        }
    }
    int status = reportProblems(*garment, messages) ? kExitSomeFailed : kExitDone;
    for (const Finding& doubt : findDoubts(*garment, {})) {
        messages.add("doubt: " + sentence(doubt));
    }
    for (const auto& piece : garment->pieces) {
        if (piece->defect) {
            messages.add(*piece->defect);
            status = kExitSomeFailed;
        }
    }
    out.flush();
    return out ? status : kExitUnreadable;
}

}  // namespace toile::app
