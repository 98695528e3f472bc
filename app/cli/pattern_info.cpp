// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/pattern_info.h"

#include <algorithm>
#include <map>
#include <ostream>

#include "app/cli/command_line.h"
#include "app/cli/input.h"
#include "core/base/characters.h"
#include "core/base/text.h"
#include "core/export/pattern_file_writer.h"
#include "core/geometry/polygon.h"
#include "core/reading/read_pattern.h"

namespace toile::app {
namespace {

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
        out << " (" << file.unitReason << (file.unitInDoubt ? "; in doubt" : "") << ")";
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

}  // namespace

bool isPatternFile(const std::filesystem::path& path) {
    return patternFileKind(path).has_value();
}

int runPatternInfo(const Arguments& arguments, std::ostream& out, std::ostream& err) {
    int status = kExitDone;
    for (const std::filesystem::path& path : arguments.inputs) {
        const auto file = readPatternFile(path, arguments.load.unit);
        if (!file) {
            err << "toile: " << sentence(file.error()) << '\n';
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
        for (const Wording& note : file->notes) {
            err << "toile: " << shownText(path.string(), kMaxOfPlace) << ": " << note << '\n';
        }
    }
    out.flush();
    return out ? status : kExitUnreadable;
}

}  // namespace toile::app
