// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/toile/toile.h"

#include <utility>

#include "core/pattern/piece_grain.h"
#include "core/project/layer_materials.h"
#include "core/project/place_pieces.h"
#include "core/toile/pipeline.h"

namespace toile {

std::vector<PieceSettings> settingsOf(const PatternOrder& order, const Garment& garment) {
    return order.pieces.empty() ? usualSettings(garment) : order.pieces;
}

MaterialList materialsOf(const PatternOrder& order, const std::vector<PieceSettings>& settings) {
    if (order.materials) {
        return *order.materials;
    }
    std::vector<std::string> used;
    for (const PieceSettings& piece : settings) {
        used.push_back(piece.material);
    }
    return materialsInUse({}, used, order.fabric);
}

ExportSource FinishedPattern::source(const ExportOptions& options, DrawingWords words,
                                     std::optional<Drawing> drawing) const {
    return {garment, results, laid, options, std::move(words), lines, fabric, std::move(drawing)};
}

Result<Garment> read(const std::vector<std::filesystem::path>& files, const LoadOptions& options,
                     const Progress& progress) {
    Progress own(progress, 1);
    return loadGarment(files, options, own);
}

PieceResults flatten(const Garment& garment, const PatternOrder& order, const Progress& progress) {
    const std::vector<PieceSettings> settings = settingsOf(order, garment);
    const MaterialList materials = materialsOf(order, settings);
    std::vector<Fabric> fabrics;
    for (const PieceSettings& piece : settings) {
        fabrics.push_back(fabricOf(piece.material, materials, order.fabric));
    }
    Progress own(progress, 1);
    return flattenGarment(garment, order.flattening, own, order.threads, order.lines,
                          pieceCloths(garment, order.lines.grain, fabrics));
}

FinishedPattern makePattern(Garment garment, PieceResults results, const PatternOrder& order,
                            std::shared_ptr<const Symmetry> symmetry) {
    if (!symmetry) {
        symmetry = symmetryOf(garment, order.lines);
    }
    Pattern pattern = makePattern(garment, results, order.lines, std::move(symmetry));
    std::vector<PieceSettings> settings = settingsOf(order, garment);
    MaterialList materials = materialsOf(order, settings);
    if (!order.pieces.empty()) {
        settings = placedSettings(std::move(settings), results,
                                  std::vector<std::optional<FlatMotion>>(results.size()), &pattern,
                                  materials, order.fabric);
    }
    for (PieceSettings& piece : settings) {
        piece.byHalf = piece.byHalf || order.byHalf;
    }
    if (order.lines.grain) {
        setGrains(settings, garment, results, pattern.symmetry.get(), *order.lines.grain, materials,
                  order.fabric);
    }
    LaidOutPattern laid =
        cutAndPlace(std::move(pattern), settings, std::move(materials), order.fabric);
    return {std::move(garment), std::move(results), std::move(laid), order.lines, order.fabric};
}

Result<Exported> write(const std::filesystem::path& file, const FinishedPattern& pattern,
                       const ExportOptions& options, const Progress& progress) {
    return exportFile(file, pattern.source(options), progress);
}

}  // namespace toile
