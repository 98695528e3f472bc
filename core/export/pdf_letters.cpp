// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/pdf_letters.h"

#include <algorithm>
#include <cmath>

#include "core/base/characters.h"
#include "core/base/text.h"
#include "core/export/pdf_file.h"
#include "core/export/text_outlines.h"

namespace toile {
namespace {

constexpr double kSizePerCapital = 1.393;  // of Helvetica
constexpr double kAverageWidth = 0.5;      // of a character, relative to its size

bool isAscii(std::string_view text) {
    return std::ranges::all_of(text, [](char c) -> bool { return c >= ' ' && c <= '~'; });
}

/// The characters in a standard font: Latin ones in one byte each, a question mark for others.
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

void appendPoint(std::string& out, const Eigen::Vector2d& point) {
    for (const double value : {point.x(), point.y()}) {
        appendFixed(out, value, 0);
        out += ' ';
    }
}

void appendOutlines(std::string& out, const TextOutlines& outlines) {
    for (const auto& contour : outlines.contours) {
        if (contour.empty()) {
            continue;
        }
        appendPoint(out, contour.front().start);
        out += "m\n";
        for (const CubicCurve& curve : contour) {
            if (!curve.isLine) {
                appendPoint(out, curve.startHandle);
                appendPoint(out, curve.endHandle);
            }
            appendPoint(out, curve.end);
            out += curve.isLine ? "l\n" : "c\n";
        }
        out += "h\n";
    }
    out += outlines.contours.empty() ? "" : "f\n";
}

/// As wide as the outlines. Without a font for these the text itself is visible.
void appendText(std::string& out, const std::string& text, const TextOutlines& outlines) {
    const std::u32string characters = codePoints(text);
    const double size = PdfLetters::kHeight * kSizePerCapital;
    const double usual = kAverageWidth * size * static_cast<double>(characters.size());
    if (!isAscii(text)) {
        out += "/Span << /ActualText " + pdfText(text) + " >> BDC\n";
    }
    out += outlines.contours.empty() ? "BT 0 Tr /F1 " : "BT 3 Tr /F1 ";
    out += pdfNumber(size) + " Tf " + pdfNumber(100 * outlines.width / usual) + " Tz " +
           latinHex(characters) + " Tj ET\n";
    out += isAscii(text) ? "" : "EMC\n";
}

}  // namespace

const PdfLetters::Line& PdfLetters::line(std::string_view text) {
    const auto known = lines_.find(text);
    if (known != lines_.end()) {
        return known->second;
    }
    Line made;
    const std::string clean = cleanText(text);
    const TextOutlines outlines = textOutlines(clean, kHeight);
    if (!clean.empty() && std::isfinite(outlines.width) && outlines.width > 0) {
        made.key = "T" + std::to_string(++count_);
        made.width = outlines.width;
        appendOutlines(made.content, outlines);
        appendText(made.content, clean, outlines);
    }
    return lines_.emplace(text, std::move(made)).first->second;
}

std::string PdfLetters::addTo(PdfFile& file, const std::string& font) const {
    std::string entries;
    for (const auto& [text, line] : lines_) {
        if (line.key.empty()) {
            continue;
        }
        // Letters of any script fit within three heights of a capital.
        const int form = file.addStream(
            "/Type /XObject /Subtype /Form /BBox [" + pdfNumber(-kHeight) + " " +
                pdfNumber(-kHeight) + " " + pdfNumber(line.width + kHeight) + " " +
                pdfNumber(2 * kHeight) + "] /Resources << /Font << " + font + " >> >>",
            line.content);
        entries += " /" + line.key + " " + pdfReference(form);
    }
    return entries;
}

}  // namespace toile
