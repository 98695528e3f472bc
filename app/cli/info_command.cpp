// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <ostream>

#include "app/cli/advice_table.h"
#include "app/cli/arguments.h"
#include "app/cli/command_line.h"
#include "app/cli/input.h"
#include "app/cli/pattern_info.h"
#include "core/base/characters.h"
#include "core/base/file.h"
#include "core/base/text.h"
#include "core/export/writers.h"
#include "core/garment/slits.h"
#include "core/io/assimp_reader.h"
#include "core/project/layer_materials.h"
#include "core/seam/seam_measure.h"

namespace toile::app {
namespace {

/// Where coordinates have passed through floats and it shows: far from the origin, or in a small
/// unit.
void printPrecision(const SourceFile& file, std::ostream& out) {
    constexpr double kTelling = 0.001;  // mm
    const double precision = file.unit.millimetres() * precisionOfFloats(*file.soup);
    if (isForAssimp(pathText(file.path.extension())) && precision > kTelling) {
        out << "coordinates have a float's precision, here " << fixed(precision, 3)
            << " mm; prefer OBJ, or move the garment to the origin\n";
    }
}

/// As what a file was read: "a thick shell (two surfaces 1.5 mm apart)".
void printReading(const FileReading& reading, std::ostream& out) {
    static constexpr Word<FileKind> kShown[] = {
        {FileKind::Sheet, "a plain sheet"},
        {FileKind::Shell, "a thick shell"},
        {FileKind::Scan, "a scan"},
        {FileKind::Layers, "layers of cloth"},
        {FileKind::Solid, "a solid, to be covered"},
        {FileKind::Soup, "a soup of triangles, joined"},
    };
    out << (reading.isStated ? "read as " : "taken for ") << wordOf(kShown, reading.kind);
    if (!reading.evidence.empty()) {
        out << " (" << reading.evidence << ")";
    }
    if (reading.leftOut.F.rows() > 0) {
        out << ", " << counted(reading.leftOut.F.rows(), "triangle") << " left out";
    }
    if (reading.kind == FileKind::Solid) {
        out << "; --auto-cut cuts it open";
    }
    if (reading.half) {
        out << (reading.half->isCompleted
                    ? ", with the mirror image added to it"
                    : "; half a garment, it seems: its rims lie over " +
                          fixed(reading.half->length, 0) +
                          " mm in one plane; --complete-half adds its other half");
    }
    out << '\n';
}

/// How many pieces each layer of a file has.
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
    if (file.up != UpAxis::Y || file.upInDoubt) {
        out << ", up " << name(file.up);
        if (!file.upReason.empty()) {
            out << " (" << file.upReason << ")";
        }
    }
    out << ", divided by " << name(file.split.mode);
    if (!file.split.reason.empty()) {
        out << " (" << file.split.reason << ")";
    }
    out << '\n';
    printReading(file.reading, out);
    printPrecision(file, out);
    if (const auto& better = file.betterSplit) {
        out << better->flat << " of " << counted(better->pieces, "piece")
            << " could lie flat as they are with --split " << name(better->mode) << '\n';
    }
}

/// The lengths of the outline and of all other loops, the longest ones where there are many.
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

/// Lines along which pieces are open inside, as UV maps have them, and what closes them.
void printSlits(const Arguments& arguments, const Garment& garment, std::ostream& out) {
    const std::vector<Slit> slits = slitsInside(garment.pieces);
    if (!slits.empty()) {
        double length = 0;
        for (const Slit& slit : slits) {
            length += slit.length;
        }
        // Not those of cuts; and a project says itself how its files are read.
        const bool canClose =
            !arguments.load.closeSlits && !arguments.project && !slitsInside(garment.uncut).empty();
        out << '\n'
            << counted(static_cast<long long>(slits.size()), "slit") << " inside pieces, "
            << fixed(length, 0) << " mm in all, whose edges lie on each other"
            << (canClose ? "; --close-slits closes them" : "") << '\n';
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

}  // namespace

int runInfo(const Arguments& arguments, std::ostream& out, std::ostream& err) {
    if (std::ranges::all_of(arguments.inputs, isPatternFile)) {
        return runPatternInfo(arguments, out, err);
    }
    Progress progress;
    const auto garment = readInput(arguments, progress, err);
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
        if (arguments.advice) {
            out << '\n';
            printAdvice(arguments, *garment, progress, out);
        }
    }
    int status = printProblems(*garment, err) ? kExitSomeFailed : kExitDone;
    for (const auto& piece : garment->pieces) {
        if (piece->defect) {
            err << "toile: " << sentence(*piece->defect) << '\n';
            status = kExitSomeFailed;
        }
    }
    out.flush();
    return out ? status : kExitUnreadable;
}

}  // namespace toile::app
