// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/apparel_text.h"

#include <string_view>

#include "core/base/text.h"
#include "core/base/version.h"
#include "core/export/dxf_tags.h"
#include "core/pattern/piece_marks.h"

namespace toile {
namespace {

/// The name of an unnamed size: grading programs require a name.
constexpr const char* kOneSize = "ONE";

std::string said(std::string_view key, std::string_view value) {
    std::string text = std::string(key) + ":";
    if (!value.empty()) {
        text.append(" ").append(value);
    }
    return dxfText(text);
}

std::string sizeOf(const ExportSource& source) {
    const std::string& size = source.laid().pattern.label.size;
    return size.empty() ? kOneSize : apparelName(size, kOneSize);
}

std::string unitsOf(const ExportSource& source) {
    return source.options().dxf.unit == LengthUnit::Inch ? "ENGLISH" : "METRIC";
}

std::string styleName(const ExportSource& source) {
    return apparelName(source.laid().pattern.name, "pattern");
}

/// Maximum distance of curves through the key points from the line, in the unit of the file.
std::string curveTolerance(const ExportSource& source) {
    return DxfTags(source.options().dxf.unit).digits(kKeyTolerance);
}

/// Copies as in the drawing, and mirrored. If the wrong side of a piece is up, the mirrored copies
/// have the right side up.
std::string quantityOf(const PatternPiece& piece, bool mirrored) {
    const bool isOnFold = piece.cutAs == CutAs::OnFold;
    const bool isPair = !isOnFold && (piece.mirroredPair || piece.cutAs == CutAs::Pair);
    // A piece on the fold is its own mirror image.
    const int count = piece.quantity * (isOnFold && piece.mirroredPair ? 2 : 1);
    const std::string own = std::to_string(count), other = isPair ? own : "0";
    return mirrored ? other + "," + own : own + "," + other;
}

}  // namespace

std::vector<std::string> pieceTexts(const ExportSource& source, const DrawnBlock& block,
                                    const std::string& name) {
    const Pattern& pattern = source.laid().pattern;
    const PatternPiece& piece = pattern.pieces[static_cast<std::size_t>(block.piece)];
    std::vector<std::string> texts{
        said("Piece Name", name),
        said("Quantity", quantityOf(piece, block.placement.mirrored)),
        said("Annotation", cuttingNote(piece, source.words(), piece.cutAs)),
        said("Category", name),
        said("Material", piece.material),
        said("Size", sizeOf(source))};
    if (piece.cutAs == CutAs::OnFold) {
        texts.push_back(said("Fold", "Y"));
    }
    return texts;
}

std::vector<std::string> controlTexts(const ExportSource& source) {
    return {said("Piece Name", kControlName),
            said("Quantity", "1,0"),
            said("Annotation", "100 mm x 100 mm"),
            said("Category", "DO NOT CUT"),
            said("Material", ""),
            said("Size", sizeOf(source))};
}

std::vector<std::string> styleTexts(const ExportSource& source) {
    const DxfOptions& options = source.options().dxf;
    const bool isAstm = options.profile == DxfProfile::Astm;
    const std::string release(version());
    std::vector<std::string> texts{said("Style Name", styleName(source)),
                                   said("Creation Date", source.laid().pattern.label.date),
                                   said("Creation Time", "")};
    if (isAstm) {
        texts.push_back(said("Author", "Toile;Toile;" + release));
    } else {  // three texts that precede the standard of 2001
        texts.push_back(said("Author", "Toile"));
        texts.push_back(said("Product", "Toile"));
        texts.push_back(said("Version", release));
    }
    texts.push_back(said("Sample Size", sizeOf(source)));
    texts.push_back(said("Grade Rule Table", options.ruleTable ? styleName(source) : ""));
    texts.push_back(said("Units", unitsOf(source)));
    texts.push_back(said(isAstm ? "Curve Tolerance" : "Tolerance", curveTolerance(source)));
    if (isAstm) {
        texts.push_back(said("ASTM/D13 Proposal 1 Version", "D6673-10"));
    }
    return texts;
}

std::string writeRuleTable(const ExportSource& source) {
    std::string table;
    for (const std::string& line :
         {said("ASTM/D13 Proposal 1 Version", "D6673-10"),
          said("Author", "Toile;Toile;" + std::string(version())),
          said("Creation Date", source.laid().pattern.label.date), said("Creation Time", ""),
          said("Grade Rule Table", styleName(source)), said("Units", unitsOf(source)),
          said("Number of Sizes", "1"), said("Size List", sizeOf(source)),
          said("Sample Size", sizeOf(source)), std::string("End")}) {
        table += line + "\r\n";
    }
    return table;
}

}  // namespace toile
