// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/pdf_content.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/export/pdf_file.h"

namespace toile {
namespace {

using Eigen::Vector2d;

constexpr std::array<const char*, kPdfLayerCount> kLayerNames{
    "cut",   "seam line", "notches", "internal lines", "marks",
    "grain", "labels",    "check",   "grid",           "pages"};

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
