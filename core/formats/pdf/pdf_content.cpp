// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/pdf/pdf_content.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>

#include <zlib.h>

#include "core/base/characters.h"
#include "core/base/id.h"
#include "core/base/text.h"
#include "core/base/units.h"
#include "core/formats/drawing/text_outlines.h"

namespace toile {
namespace {

constexpr int kLevel = 2;  // of nine: twice as fast as the default, for files a tenth larger
constexpr std::size_t kOffsetDigits = 10;

std::string deflated(std::string_view bytes) {
    uLongf size = compressBound(static_cast<uLong>(bytes.size()));
    std::vector<Bytef> packed(size);
    const std::vector<Bytef> plain(bytes.begin(), bytes.end());
    const int done =
        compress2(packed.data(), &size, plain.data(), static_cast<uLong>(plain.size()), kLevel);
    assert(done == Z_OK);  // the buffer is large enough
    static_cast<void>(done);
    return {packed.begin(), packed.begin() + static_cast<std::ptrdiff_t>(size)};
}

void appendHex(std::string& out, std::uint64_t value, int digits) {
    for (int k = digits - 1; k >= 0; --k) {
        out += "0123456789ABCDEF"[(value >> (4 * k)) & 15];
    }
}

/// UTF-16 with its byte order mark, in hexadecimal.
std::string utf16Hex(std::string_view text) {
    std::string hex = "<FEFF";
    for (const char32_t c : codePoints(text)) {
        if (c > 0xFFFF) {
            appendHex(hex, 0xD800 + ((c - 0x10000) >> 10), 4);
            appendHex(hex, 0xDC00 + ((c - 0x10000) & 0x3FF), 4);
        } else {
            appendHex(hex, c, 4);
        }
    }
    return hex + ">";
}

}  // namespace

int PdfFile::reserve() {
    bodies_.emplace_back();
    return static_cast<int>(bodies_.size());
}

void PdfFile::set(int number, std::string body) {
    bodies_.at(static_cast<std::size_t>(number) - 1) = std::move(body);
}

void PdfFile::setStream(int number, std::string_view entries, std::string_view bytes) {
    const std::string packed = deflated(bytes);
    std::string body = "<< ";
    body.append(entries).append(" /Filter /FlateDecode /Length ");
    body += std::to_string(packed.size()) + " >>\nstream\n";
    set(number, body + packed + "\nendstream");
}

int PdfFile::add(std::string body) {
    const int number = reserve();
    set(number, std::move(body));
    return number;
}

int PdfFile::addStream(std::string_view entries, std::string_view bytes) {
    const int number = reserve();
    setStream(number, entries, bytes);
    return number;
}

std::string PdfFile::finished(int catalog, int info) const {
    // Four non-text bytes mark the file as binary for transfer programs.
    std::string out = "%PDF-1.7\n%\xE2\xE3\xCF\xD3\n";
    std::vector<std::size_t> offsets;
    for (std::size_t k = 0; k < bodies_.size(); ++k) {
        assert(!bodies_[k].empty());
        offsets.push_back(out.size());
        out += std::to_string(k + 1) + " 0 obj\n" + bodies_[k] + "\nendobj\n";
    }
    std::string id = "<";
    appendHex(id, contentHash(out), 16);
    appendHex(id, contentHash(id), 16);
    id += ">";
    const std::size_t table = out.size();
    const std::string count = std::to_string(bodies_.size() + 1);
    // Each entry is twenty bytes long, including two for the line end.
    out += "xref\n0 " + count + "\n0000000000 65535 f \n";
    for (const std::size_t offset : offsets) {
        const std::string digits = std::to_string(offset);
        out.append(kOffsetDigits - std::min(kOffsetDigits, digits.size()), '0').append(digits);
        out += " 00000 n \n";
    }
    out += "trailer\n<< /Size " + count + " /Root " + pdfReference(catalog) + " /Info " +
           pdfReference(info) + " /ID [" + id + " " + id + "] >>\nstartxref\n" +
           std::to_string(table) + "\n%%EOF\n";
    return out;
}

std::string pdfReference(int number) {
    return std::to_string(number) + " 0 R";
}

std::string pdfText(std::string_view text) {
    const std::string clean = cleanText(text);
    if (!std::ranges::all_of(clean, [](char c) -> bool { return c >= ' ' && c <= '~'; })) {
        return utf16Hex(clean);
    }
    std::string literal = "(";
    for (const char c : clean) {
        if (c == '(' || c == ')' || c == '\\') {
            literal += '\\';
        }
        literal += c;
    }
    return literal + ")";
}

std::string pdfPoints(double millimetres) {
    return pdfNumber(millimetres * kPointsPerMillimetre);
}

std::string pdfNumber(double value) {
    std::string text;
    appendPdfNumber(text, value);
    return text;
}

void appendPdfNumber(std::string& out, double value, int decimals) {
    const std::size_t start = out.size();
    appendFixed(out, value, decimals);
    if (out.find('.', start) != std::string::npos) {
        while (out.back() == '0') {
            out.pop_back();
        }
        if (out.back() == '.') {
            out.pop_back();
        }
    }
}

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

namespace {

using Eigen::Vector2d;

constexpr int kMatrixDigits = 10;  // decimals: a page is thousands of millimetres long

/// Numbers and names of tiles, "12" and "B3": many texts of few characters.
bool isCode(std::string_view text) {
    constexpr std::size_t kLongest = 6;
    return text.size() <= kLongest && std::ranges::all_of(text, [](char c) -> bool {
               return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z');
           });
}

}  // namespace

const char* pdfLayerName(int layer) {
    return layer == kGridLayer   ? "grid"
           : layer == kPageLayer ? "pages"
                                 : kLayerNames.at(static_cast<std::size_t>(layer)).pdf;
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
    for (const double value : {a, b, c, d}) {
        appendPdfNumber(out_, value, kMatrixDigits);
        out_ += ' ';
    }
    point(move);
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
            continue;  // closing the line draws it
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

double PdfContent::text(std::string_view text, const Vector2d& position, double height,
                        TextStart start, double angle, double most) {
    std::vector<std::string_view> parts;
    if (isCode(text)) {
        for (std::size_t k = 0; k < text.size(); ++k) {
            parts.push_back(text.substr(k, 1));
        }
    } else {
        parts.push_back(text);
    }
    double width = 0;
    for (const std::string_view part : parts) {
        width += letters_->line(part).width;
    }
    if (!(width > 0)) {
        return 0;
    }
    double scale = height / PdfLetters::kHeight;
    scale = most > 0 ? std::min(scale, most / width) : scale;
    const Vector2d along = scale * Vector2d(std::cos(angle), std::sin(angle));
    double at = start == TextStart::Middle ? -0.5 * width : 0;
    for (const std::string_view part : parts) {
        const PdfLetters::Line& line = letters_->line(part);
        if (line.key.empty()) {
            continue;
        }
        save();
        transform(along.x(), along.y(), -along.y(), along.x(), position + at * along);
        form(line.key);
        restore();
        at += line.width;
    }
    return scale * width;
}

}  // namespace toile
