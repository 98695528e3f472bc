// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/pdf_content.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/characters.h"
#include "core/base/text.h"
#include "core/export/pdf_file.h"

namespace toile {
namespace {

using Eigen::Vector2d;

constexpr std::array<const char*, kPdfLayerCount> kLayerNames{
    "cut",   "seam line", "notches", "internal lines", "marks",
    "grain", "labels",    "check",   "grid",           "pages"};

constexpr int kMatrixDigits = 12;          // decimals: a page is thousands of millimetres long
constexpr double kSizePerCapital = 1.393;  // of Helvetica
constexpr double kLetterUnits = 1000;      // of a capital's height: whole ones are fine enough
constexpr double kAverageWidth = 0.5;      // of a character of it, in its size

bool isAscii(std::string_view text) {
    return std::ranges::all_of(text, [](char c) -> bool { return c >= ' ' && c <= '~'; });
}

/// The characters of a standard font: Latin ones in one byte each, others unseen ones.
std::string latinHex(const std::u32string& characters) {
    std::string hex = "<";
    for (const char32_t c : characters) {
        const bool isLatin = (c >= 0x20 && c < 0x7F) || (c >= 0xA0 && c <= 0xFF);
        const char32_t byte = isLatin ? c : U'?';
        hex += "0123456789ABCDEF"[byte >> 4];
        hex += "0123456789ABCDEF"[byte & 15];
    }
    return hex + ">";
}

}  // namespace

const char* pdfLayerName(int layer) {
    return kLayerNames.at(static_cast<std::size_t>(layer));
}

std::string pdfLayerKey(int layer) {
    return "L" + std::to_string(layer);
}

void PdfContent::number(double value) {
    appendPdfNumber(out_, value);
    out_ += ' ';
}

void PdfContent::point(const Vector2d& point) {
    number(point.x());
    number(point.y());
}

void PdfContent::transform(double a, double b, double c, double d, const Vector2d& move) {
    for (const double value : {a, b, c, d, move.x(), move.y()}) {
        appendFixed(out_, value, kMatrixDigits);
        out_ += ' ';
    }
    out_ += "cm\n";
}

void PdfContent::clip(const Eigen::AlignedBox2d& box) {
    point(box.min());
    point(box.sizes());
    out_ += "re W n\n";
}

void PdfContent::form(std::string_view name) {
    out_.append("/").append(name).append(" Do\n");
}

void PdfContent::beginLayer(int layer) {
    out_ += "/OC /" + pdfLayerKey(layer) + " BDC\n";
}

void PdfContent::beginItem(std::string_view id, std::string_view piece) {
    out_ += "/Toile << /Id " + pdfText(id);
    if (!piece.empty()) {
        out_ += " /Piece " + pdfText(piece);
    }
    out_ += " >> BDC\n";
}

void PdfContent::setGrey(double grey) {
    number(grey);
    out_ += "G ";
    number(grey);
    out_ += "g\n";
}

void PdfContent::setWidth(double width) {
    number(width);
    out_ += "w\n";
}

void PdfContent::setDashes(double line, double gap) {
    out_ += "[";
    point({line, gap});
    out_ += "] 0 d\n";
}

void PdfContent::setRoundEnds() {
    out_ += "1 J 1 j\n";
}

void PdfContent::line(const Points2& points, bool closed) {
    for (Eigen::Index k = 0; k < points.rows(); ++k) {
        point(points.row(k));
        out_ += k == 0 ? "m\n" : "l\n";
    }
    out_ += closed ? "s\n" : "S\n";
}

void PdfContent::curves(const std::vector<CubicCurve>& curves, bool closed) {
    point(curves.front().start);
    out_ += "m\n";
    for (std::size_t k = 0; k < curves.size(); ++k) {
        if (!curves[k].isLine) {
            point(curves[k].startHandle);
            point(curves[k].endHandle);
        } else if (closed && k + 1 == curves.size()) {
            continue;  // what closes the line draws it
        }
        point(curves[k].end);
        out_ += curves[k].isLine ? "l\n" : "c\n";
    }
    out_ += closed ? "s\n" : "S\n";
}

void PdfContent::box(const Eigen::AlignedBox2d& box) {
    point(box.min());
    point(box.sizes());
    out_ += "re S\n";
}

void PdfContent::segment(const Vector2d& from, const Vector2d& to) {
    point(from);
    out_ += "m ";
    point(to);
    out_ += "l S\n";
}

void PdfContent::text(std::string_view line, const Vector2d& position, double height,
                      TextStart start, double angle, double most) {
    const std::string clean = cleanText(line);
    const std::u32string characters = codePoints(clean);
    const TextOutlines outlines = textOutlines(clean, kLetterUnits);
    if (characters.empty() || !std::isfinite(outlines.width) || !(outlines.width > 0)) {
        return;
    }
    double scale = height / kLetterUnits;
    scale = most > 0 ? std::min(scale, most / outlines.width) : scale;
    const double left = start == TextStart::Middle ? -0.5 * scale * outlines.width : 0;
    const Vector2d along(std::cos(angle), std::sin(angle));
    save();
    transform(scale * along.x(), scale * along.y(), -scale * along.y(), scale * along.x(),
              position + left * along);
    letters(outlines);
    // Without a font for the outlines the text itself is seen.
    unseenText(clean, characters, outlines.width, outlines.contours.empty());
    restore();
}

void PdfContent::letters(const TextOutlines& outlines) {
    const auto whole = [this](const Vector2d& point) {
        for (const double value : {point.x(), point.y()}) {
            appendFixed(out_, value, 0);
            out_ += ' ';
        }
    };
    for (const auto& contour : outlines.contours) {
        if (contour.empty()) {
            continue;
        }
        whole(contour.front().start);
        out_ += "m\n";
        for (const CubicCurve& curve : contour) {
            if (!curve.isLine) {
                whole(curve.startHandle);
                whole(curve.endHandle);
            }
            whole(curve.end);
            out_ += curve.isLine ? "l\n" : "c\n";
        }
        out_ += "h\n";
    }
    out_ += outlines.contours.empty() ? "" : "f\n";
}

void PdfContent::unseenText(const std::string& text, const std::u32string& characters, double width,
                            bool isSeen) {
    const double size = kLetterUnits * kSizePerCapital;
    const double usual = kAverageWidth * size * static_cast<double>(characters.size());
    if (!isAscii(text)) {
        out_ += "/Span << /ActualText " + pdfText(text) + " >> BDC\n";
    }
    out_ += isSeen ? "BT 0 Tr /F1 " : "BT 3 Tr /F1 ";
    number(size);
    out_ += "Tf ";
    number(100 * width / usual);
    out_ += "Tz " + latinHex(characters) + " Tj ET\n";
    if (!isAscii(text)) {
        end();
    }
}

}  // namespace toile
