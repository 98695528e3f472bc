// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "core/base/characters.h"
#include "core/base/text.h"
#include "core/base/version.h"
#include "core/formats/tables/report_tables.h"
#include "core/formats/writers.h"

namespace toile {
namespace {

std::vector<ReportPicture> (*makePictures)(const ExportSource&) = nullptr;

constexpr const char* kStyle =
    "body{font:15px/1.45 sans-serif;color:#222;background:#fff;max-width:1100px;"
    "margin:2em auto;padding:0 1em}"
    "h1{font-size:1.6em;margin-bottom:.2em}h2{font-size:1.15em;margin-top:2em}"
    "p.sum{color:#555;margin-top:0}"
    "figure{margin:1em 0;border:1px solid #ddd}"
    "figure svg,figure img{display:block;width:100%;height:auto}"
    "figcaption{padding:.3em .7em;color:#555;font-size:.9em}"
    "div.wide{overflow-x:auto}"
    "table{border-collapse:collapse;font-size:.9em}"
    "th,td{padding:.25em .7em;text-align:right;white-space:nowrap;border-bottom:1px solid #e4e4e4}"
    "th:first-child,td:first-child{text-align:left}"
    "th{color:#555;font-weight:600}"
    "@media print{body{margin:0}h2{break-after:avoid}tr{break-inside:avoid}}";

/// Text escaped for HTML.
std::string htmlText(std::string_view text) {
    std::string out;
    for (const char c : cleanText(text)) {
        out += c == '&'   ? "&amp;"
               : c == '<' ? "&lt;"
               : c == '>' ? "&gt;"
               : c == '"' ? "&quot;"
                          : std::string(1, c);
    }
    return out;
}

void appendTable(std::string& out, const ReportTable& table) {
    if (table.rows.empty()) {
        return;
    }
    out += "<h2>" + htmlText(table.title) + "</h2>\n<div class=\"wide\"><table>\n<thead><tr>";
    for (const std::string& head : table.head) {
        out += "<th>" + htmlText(head) + "</th>";
    }
    out += "</tr></thead>\n<tbody>\n";
    for (const auto& row : table.rows) {
        out += "<tr>";
        for (const std::string& cell : row) {
            out += "<td>" + htmlText(cell) + "</td>";
        }
        out += "</tr>\n";
    }
    out += "</tbody>\n</table></div>\n";
}

void appendPicture(std::string& out, const ReportPicture& picture) {
    const std::string caption = htmlText(picture.caption);
    out += "<figure>\n<img alt=\"" + caption + "\" src=\"data:image/png;base64," + picture.png +
           "\">\n<figcaption>" + caption + "</figcaption>\n</figure>\n";
}

/// The drawing without the parts that only a separate file needs.
std::string inlineSvg(const Drawing& drawing) {
    std::string svg = writeSvg(drawing);
    svg.erase(0, svg.find("<svg"));
    return svg;
}

std::string summary(const ExportSource& source) {
    const auto seams = seamsByError(source.garment(), source.results());
    std::string text = counted(static_cast<long long>(source.drawing().blocks.size()), "piece");
    if (!seams.empty()) {
        text += ", " + counted(static_cast<long long>(seams.size()), "seam") +
                ", largest error of a seam " + fixed(std::abs(seams.front().measure.errorMm), 6) +
                " mm";
    }
    const LabelTexts& label = source.laid().pattern.label;
    text += label.size.empty() ? "" : ", size " + label.size;
    text += label.date.empty() ? "" : ", " + label.date;
    return text;
}

}  // namespace

void provideReportPictures(std::vector<ReportPicture> (*make)(const ExportSource&)) {
    makePictures = make;
}

std::string writeHtmlReport(const ExportSource& source) {
    const Drawing& drawing = source.drawing();
    const std::string title = htmlText(drawing.title);
    std::string out =
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"generator\" content=\"Toile " +
        std::string(version()) + "\">\n<title>" + title + "</title>\n<style>" + kStyle +
        "</style>\n</head>\n<body>\n<h1>" + title + "</h1>\n<p class=\"sum\">" +
        htmlText(summary(source)) + "</p>\n";
    out += "<figure>\n" + inlineSvg(drawing) + "</figure>\n";
    for (const ReportPicture& picture :
         makePictures ? makePictures(source) : std::vector<ReportPicture>()) {
        appendPicture(out, picture);
    }
    appendTable(out, pieceTable(source.laid().pattern, source.results()));
    appendTable(out, ledgerTable(source.garment(), source.results()));
    appendTable(out, edgeTable(source.laid().pattern));
    const WalkedGarment walked = walkGarment(source.garment(), source.results(),
                                             source.laid().pattern, source.lines().notches);
    appendTable(out, walkTable(source.garment(), walked.notches, walked.walks));
    return out + "</body>\n</html>\n";
}

}  // namespace toile
