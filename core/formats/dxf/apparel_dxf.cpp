// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/dxf/apparel_dxf.h"

#include <cmath>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/characters.h"
#include "core/base/text.h"
#include "core/base/version.h"
#include "core/formats/dxf/apparel_pieces.h"
#include "core/formats/dxf/dxf_tags.h"
#include "core/pattern/label.h"
#include "core/pattern/notch_mark.h"
#include "core/pattern/piece_marks.h"

namespace toile {
namespace {

/// The name of an unnamed size: grading programs require a name.
constexpr const char* kOneSize = "ONE";

std::string textOf(std::string_view key, std::string_view value) {
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
        textOf("Piece Name", name),
        textOf("Quantity", quantityOf(piece, block.placement.mirrored)),
        textOf("Annotation", cuttingNote(piece, source.words(), piece.cutAs)),
        textOf("Category", name),
        textOf("Material", piece.material),
        textOf("Size", sizeOf(source))};
    if (piece.cutAs == CutAs::OnFold) {
        texts.push_back(textOf("Fold", "Y"));
    }
    return texts;
}

std::vector<std::string> controlTexts(const ExportSource& source) {
    return {textOf("Piece Name", kControlName),
            textOf("Quantity", "1,0"),
            textOf("Annotation", "100 mm x 100 mm"),
            textOf("Category", "DO NOT CUT"),
            textOf("Material", ""),
            textOf("Size", sizeOf(source))};
}

std::vector<std::string> styleTexts(const ExportSource& source) {
    const DxfOptions& options = source.options().dxf;
    const bool isAstm = options.profile == DxfProfile::Astm;
    const std::string release(version());
    std::vector<std::string> texts{textOf("Style Name", styleName(source)),
                                   textOf("Creation Date", source.laid().pattern.label.date),
                                   textOf("Creation Time", "")};
    if (isAstm) {
        texts.push_back(textOf("Author", "Toile;Toile;" + release));
    } else {  // three texts that precede the standard of 2001
        texts.push_back(textOf("Author", "Toile"));
        texts.push_back(textOf("Product", "Toile"));
        texts.push_back(textOf("Version", release));
    }
    texts.push_back(textOf("Sample Size", sizeOf(source)));
    texts.push_back(textOf("Grade Rule Table", options.ruleTable ? styleName(source) : ""));
    texts.push_back(textOf("Units", unitsOf(source)));
    if (options.unit != LengthUnit::Inch) {  // METRIC is mm, but programs use it for cm, too
        texts.push_back(textOf("Unit", std::string(symbol(options.unit))));
    }
    texts.push_back(textOf(isAstm ? "Curve Tolerance" : "Tolerance", curveTolerance(source)));
    if (isAstm) {
        texts.push_back(textOf("ASTM/D13 Proposal 1 Version", "D6673-10"));
    }
    return texts;
}

std::string writeRuleTable(const ExportSource& source) {
    std::string table;
    for (const std::string& line :
         {textOf("ASTM/D13 Proposal 1 Version", "D6673-10"),
          textOf("Author", "Toile;Toile;" + std::string(version())),
          textOf("Creation Date", source.laid().pattern.label.date), textOf("Creation Time", ""),
          textOf("Grade Rule Table", styleName(source)), textOf("Units", unitsOf(source)),
          textOf("Number of Sizes", "1"), textOf("Size List", sizeOf(source)),
          textOf("Sample Size", sizeOf(source)), std::string("End")}) {
        table += line + "\r\n";
    }
    return table;
}

namespace {

constexpr double kSystemText = 2.5;   // mm, height
constexpr double kSystemLine = 3.75;  // mm, from one to the next

class ApparelWriter {
public:
    ApparelWriter(const ExportSource& source, const Drawing& drawing,
                  const std::vector<ApparelPiece>& pieces)
        : source_(source),
          drawing_(drawing),
          pieces_(pieces),
          options_(source.options().dxf),
          out_(options_.unit) {}

    std::string written() {
        out_.beginSection("HEADER");
        out_.endSection();
        out_.beginSection("BLOCKS");
        for (const ApparelPiece& piece : pieces_) {
            addPiece(piece);
        }
        if (options_.controlPiece) {
            addControlPiece();
        }
        out_.endSection();
        out_.beginSection("ENTITIES");
        addTexts(styleTexts(source_), {0, 0});
        for (const ApparelPiece& piece : pieces_) {
            addInsert(piece.name);
        }
        if (options_.controlPiece) {
            addInsert(kControlName);
        }
        out_.endSection();
        out_.tag(0, "EOF");
        return out_.take();
    }

private:
    bool isAstm() const { return options_.profile == DxfProfile::Astm; }

    void begin(const char* kind, int layer) {
        out_.tag(0, kind);
        out_.tag(8, std::to_string(layer));
    }

    void beginBlock(const std::string& name) {
        begin("BLOCK", kCutLayer);
        out_.tag(2, name);
        out_.tag(70, 64);  // referenced
        out_.flatPoint(10, {0, 0});
        out_.tag(3, name);
    }

    void endBlock() { begin("ENDBLK", kCutLayer); }

    void addInsert(const std::string& name) {
        begin("INSERT", kCutLayer);
        out_.tag(2, name);
        out_.flatPoint(10, {0, 0});
    }

    void addText(int layer, const std::string& text, const Eigen::Vector2d& at, double height,
                 double angle = 0) {
        begin("TEXT", layer);
        out_.flatPoint(10, at);
        out_.length(40, height);
        out_.tag(1, text);
        if (angle != 0) {
            out_.number(50, angle / kDegree);
        }
    }

    void addTexts(const std::vector<std::string>& texts, Eigen::Vector2d at) {
        for (const std::string& text : texts) {
            addText(kCutLayer, text, at, kSystemText);
            at.y() -= kSystemLine;
        }
    }

    using Digits = std::pair<std::string, std::string>;

    Digits digitsOf(const Points2& points, Eigen::Index k) const {
        return {out_.digits(points(k, 0)), out_.digits(points(k, 1))};
    }

    /// Merges neighbouring points with equal digits. @return the written rows
    std::vector<Eigen::Index> addPolyline(int layer, const Points2& points, bool closed) {
        begin("POLYLINE", layer);
        out_.tag(66, 1);  // vertices follow
        out_.tag(70, closed ? 1 : 0);
        std::vector<Eigen::Index> rows;
        Digits first, before;
        for (Eigen::Index k = 0; k < points.rows(); ++k) {
            Digits digits = digitsOf(points, k);
            const bool isLast = k + 1 == points.rows();
            if (k > 0 && (digits == before || (closed && isLast && digits == first))) {
                continue;
            }
            begin("VERTEX", layer);
            out_.tag(10, digits.first);
            out_.tag(20, digits.second);
            first = k == 0 ? digits : first;
            before = std::move(digits);
            rows.push_back(k);
        }
        begin("SEQEND", layer);
        return rows;
    }

    void addPoint(int layer, const Digits& digits) {
        begin("POINT", layer);
        out_.tag(10, digits.first);
        out_.tag(20, digits.second);
    }

    void addLine(int layer, const Chord& line) {
        begin("LINE", layer);
        out_.flatPoint(10, line.from);
        out_.flatPoint(11, line.to);
    }

    /// Writes a point shared by several lines once, as a turn point if it is one on any of them.
    void addPrimaries(const ApparelPiece& piece) {
        std::set<Digits> turns, named;
        for (const ApparelLine& line : piece.lines) {
            for (Eigen::Index k = 0; k < line.keys.rows(); ++k) {
                if (line.isTurn[static_cast<std::size_t>(k)]) {
                    turns.insert(digitsOf(line.keys, k));
                }
            }
        }
        for (const ApparelLine& line : piece.lines) {
            for (const Eigen::Index k : addPolyline(line.layer, line.keys, line.closed)) {
                const Digits digits = digitsOf(line.keys, k);
                if (named.insert(digits).second) {
                    addPoint(turns.contains(digits) ? kTurnLayer : kCurveLayer, digits);
                }
            }
            if (isAstm()) {
                addPolyline(validationLayer(line.layer), line.dense, line.closed);
            }
        }
    }

    void addNotch(const ApparelNotch& notch) {
        const NotchForm form = source_.laid().pattern.notchForm;
        const bool hasWidth = form == NotchForm::V || (form != NotchForm::Slit && isAstm());
        const bool isT = form == NotchForm::T, isCastle = form == NotchForm::Castle;
        begin("POINT", isAstm() && isT        ? kTNotchLayer
                       : isAstm() && isCastle ? kCastleNotchLayer
                                              : kNotchLayer);
        out_.flatPoint(10, notch.point);
        out_.length(30, notch.depth);
        if (hasWidth) {
            out_.length(39, NotchSize{}.width);
        }
        const double angle = std::atan2(notch.inwards.y(), notch.inwards.x());
        out_.number(50, angle < 0 ? angle / kDegree + 360 : angle / kDegree);
    }

    /// @param name  of the piece in the file, used if the label's own has no letters there
    void addLabel(const DrawnBlock& block, const std::string& name) {
        for (std::size_t k = block.text; k < block.text + block.textCount; ++k) {
            const DrawnText& text = drawing_.texts[k];
            if (text.layer != LayerKind::Text) {
                continue;
            }
            Eigen::Vector2d middle = text.position - Eigen::Vector2d(0, 0.5 * text.height);
            for (const std::string& words : text.lines) {
                const std::string plain = dxfText(words);
                const bool isLost = plain.find_first_not_of(" _") == std::string::npos;
                const std::string& line = isLost && !plain.empty() ? name : plain;
                const double width = textExtent({line}, text.height).x();
                addText(kTextLayer, line, middle - Eigen::Vector2d(0.5 * width, 0), text.height);
                middle.y() -= kLineSpacing * text.height;
            }
        }
    }

    void addPiece(const ApparelPiece& piece) {
        const DrawnBlock& block = drawing_.blocks[piece.block];
        beginBlock(piece.name);
        addTexts(pieceTexts(source_, block, piece.name), piece.middle);
        addPrimaries(piece);
        addLine(kGrainLayer, piece.grain);
        if (piece.mirror) {
            addLine(kMirrorLayer, *piece.mirror);
        }
        for (const ApparelNotch& notch : piece.notches) {
            addNotch(notch);
        }
        for (const Eigen::Vector2d& drill : piece.drills) {
            begin("POINT", kDrillLayer);
            out_.flatPoint(10, drill);
            out_.length(30, kDrillDiameter);
        }
        addLabel(block, piece.name);
        endBlock();
    }

    void addControlPiece() {
        for (const DrawnPath& path : drawing_.paths) {
            if (path.layer != LayerKind::Check) {
                continue;
            }
            const Eigen::Vector2d middle = path.points.colwise().mean().transpose();
            const Eigen::Vector2d up(0, 0.25 * (path.points.row(2) - path.points.row(1)).norm());
            beginBlock(kControlName);
            addTexts(controlTexts(source_), middle);
            for (const Eigen::Index k : addPolyline(kCutLayer, path.points, true)) {
                addPoint(kTurnLayer, digitsOf(path.points, k));
            }
            if (isAstm()) {
                addPolyline(validationLayer(kCutLayer), path.points, true);
            }
            addLine(kGrainLayer, {middle - up, middle + up});
            endBlock();
        }
    }

    const ExportSource& source_;
    const Drawing& drawing_;
    const std::vector<ApparelPiece>& pieces_;
    DxfOptions options_;
    DxfTags out_;
};

}  // namespace

std::vector<Wording> renamedNotes(const ExportSource& source) {
    constexpr std::size_t kMaxListed = 10;
    const Pattern& pattern = source.laid().pattern;
    const Drawing& drawing = source.drawing();
    const bool isPlain = source.options().dxf.profile == DxfProfile::Plain;
    const std::vector<std::string> names = apparelNames(pattern, drawing);
    std::vector<std::string> changed;
    std::set<int> seen;
    for (std::size_t b = 0; b < names.size(); ++b) {
        const int index = drawing.blocks[b].piece;
        const std::string& name = pattern.pieces[static_cast<std::size_t>(index)].name;
        if (asciiText(name) != name && seen.insert(index).second) {
            changed.push_back(name + " = " + (isPlain ? dxfText(name) : names[b]));
        }
    }
    if (changed.empty()) {
        return {};
    }
    return {worded("DXF files hold names in plain Latin letters, so these were changed: %1",
                   {quotedList(changed, kMaxListed)})};
}

std::string writeApparelDxf(const ExportSource& source) {
    const ApparelDrawing made = apparelDrawing(source);
    const std::vector<ApparelPiece> pieces = apparelPieces(source, made);
    return ApparelWriter(source, made.drawing, pieces).written();
}

}  // namespace toile
