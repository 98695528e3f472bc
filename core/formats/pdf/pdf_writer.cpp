// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/pdf/pdf_writer.h"

#include <algorithm>

#include "core/base/version.h"
#include "core/formats/drawing/sheet_drawing.h"
#include "core/formats/pdf/pdf_content.h"
#include "core/formats/pdf/pdf_pages.h"
#include "core/formats/pdf/sheets.h"
#include "core/pattern/label.h"

namespace toile {
namespace {

using Eigen::AlignedBox2d;

constexpr double kPageScale = 72 / 25.4;           // points per mm
constexpr SheetLineWidths kOnScreen{1.5, 1, 0.8};  // mm: thick enough for a projector

bool isOnTiles(Paper paper) {
    return paper == Paper::A4 || paper == Paper::Letter || paper == Paper::Shared;
}

Points2 withFirstRepeated(const Points2& points) {
    Points2 closed(points.rows() + 1, 2);
    closed << points, points.row(0);
    return closed;
}

PrintedContent contentOf(const Drawing& drawing, const std::vector<LayerKind>& layers) {
    PrintedContent content;
    const auto isWritten = [&](LayerKind layer) -> bool {
        return std::ranges::find(layers, layer) != layers.end();
    };
    const auto add = [&](const Points2& line) {
        for (Eigen::Index k = 0; k < line.rows(); ++k) {
            content.box.extend(line.row(k).transpose());
        }
        content.lines.push_back(line);
    };
    for (const DrawnPath& path : drawing.paths) {
        if (!isWritten(path.layer) || path.points.rows() == 0) {
            continue;
        }
        add(path.closed ? withFirstRepeated(path.points) : path.points);
        if (path.closed && path.layer == LayerKind::Cut) {
            content.areas.push_back(path.points);
        }
    }
    for (const DrawnText& text : drawing.texts) {
        if (isWritten(text.layer)) {
            add(textBox({text.position, text.height}, text.lines, text.angle, 0));
        }
    }
    if (const AlignedBox2d squares = squaresBeside(drawing);
        isWritten(LayerKind::Check) && !squares.isEmpty()) {
        content.box.extend(squares);
    }
    return content;
}

/// Objects that every page refers to.
struct Shared {
    int pages = 0;
    std::string resources;
};

struct Sheet {
    Eigen::Vector2d paper;
    std::string content;
};

std::vector<Sheet> sheetsOf(const Drawing& drawing, const PdfPlan& plan, bool hasGrid,
                            PdfLetters& letters) {
    std::vector<Sheet> sheets;
    for (std::size_t k = 0; k < sheetCount(plan); ++k) {
        PdfContent out(letters);
        out.save();
        out.transform(kPageScale, 0, 0, kPageScale, Eigen::Vector2d::Zero());
        drawSheet(out, drawing, plan, k, hasGrid);
        out.restore();
        sheets.push_back({sheetPaper(plan, k), out.take()});
    }
    return sheets;
}

void addPage(PdfFile& file, const Shared& shared, std::vector<int>& pages, const Sheet& sheet) {
    const std::string box =
        "[0 0 " + pdfPoints(sheet.paper.x()) + " " + pdfPoints(sheet.paper.y()) + "]";
    const int stream = file.addStream("", sheet.content);
    pages.push_back(file.add("<< /Type /Page /Parent " + pdfReference(shared.pages) +
                             " /MediaBox " + box + " /CropBox " + box + " /TrimBox " + box +
                             " /Resources " + shared.resources + " /Contents " +
                             pdfReference(stream) + " >>"));
}

std::string references(const std::vector<int>& numbers) {
    std::string text = "[";
    for (const int number : numbers) {
        text += (text.size() > 1 ? " " : "") + pdfReference(number);
    }
    return text + "]";
}

/// Layers: their keys in resources, and their order and visibility in viewers.
struct LayerObjects {
    std::string properties, listing;
};

LayerObjects addLayers(PdfFile& file, const std::vector<int>& layers) {
    std::vector<int> all, shown, hidden;
    LayerObjects made;
    for (const int layer : layers) {
        const int number = file.add("<< /Type /OCG /Name " + pdfText(pdfLayerName(layer)) + " >>");
        made.properties += " /" + pdfLayerKey(layer) + " " + pdfReference(number);
        all.push_back(number);
        (layer == kGridLayer ? hidden : shown).push_back(number);
    }
    made.listing = "<< /OCGs " + references(all) + " /D << /Name " + pdfText("Layers") +
                   " /Order " + references(all) + " /ON " + references(shown) + " /OFF " +
                   references(hidden) + " >> >>";
    return made;
}

/// Names of the pages in viewers.
std::string pageLabels(const PdfPlan& plan) {
    std::string labels = "<< /Nums [";
    std::size_t number = 0;
    if (plan.isTiled) {
        labels += " 0 << /P " + pdfText("map") + " >>";
        for (const PdfPage& page : plan.pages) {
            labels += " " + std::to_string(++number) + " << /P " + pdfText(tileName(page)) + " >>";
        }
    } else {
        labels += " 0 << /S /D >>";
    }
    return labels + " ] >>";
}

}  // namespace

std::vector<LayerKind> pdfLayers(const Drawing& drawing, bool isTiled) {
    std::vector<LayerKind> layers;
    for (const LayerKind kind : kLayerKinds) {
        if (hasLayer(drawing, kind) && !(kind == LayerKind::Check && isTiled)) {
            layers.push_back(kind);
        }
    }
    return layers;
}

Result<PdfPlan> planPdf(const Drawing& drawing, const PdfOptions& options) {
    const bool isTiled = isOnTiles(options.paper);
    Result<PdfPlan> plan = planPages(contentOf(drawing, pdfLayers(drawing, isTiled)), options);
    if (plan && plan->isTiled && !isTiled) {
        // Too large for one sheet. Tiles have the squares on the first page.
        plan = planPages(contentOf(drawing, pdfLayers(drawing, true)), options, true);
    }
    return plan;
}

Result<std::string> writePdf(const Drawing& drawing, const Pattern& pattern,
                             const PdfOptions& options) {
    const Result<PdfPlan> plan = planPdf(drawing, options);
    if (!plan) {
        return plan.error();
    }
    const std::vector<LayerKind> kinds = pdfLayers(drawing, plan->isTiled);
    const bool isProjected = options.paper == Paper::Projector;
    std::vector<int> layers;
    for (const LayerKind kind : kLayerKinds) {
        if (hasLayer(drawing, kind)) {
            layers.push_back(static_cast<int>(kind));  // including Check, for the squares
        }
    }
    if (isProjected) {
        layers.push_back(kGridLayer);
    }
    if (plan->isTiled) {
        layers.push_back(kPageLayer);
    }

    PdfFile file;
    const int catalog = file.reserve();
    const int info =
        file.add("<< /Title " + pdfText(drawing.title) + " /Creator (Toile) /Producer " +
                 pdfText("Toile " + std::string(version())) + " >>");
    const LayerObjects listed = addLayers(file, layers);
    const int font = file.add(
        "<< /Type /Font /Subtype /Type1 /BaseFont /Helvetica /Encoding /WinAnsiEncoding >>");
    const std::string fonts = "/F1 " + pdfReference(font);
    // Create the contents of all pages first, because each text is stored once in the file.
    PdfLetters letters;
    PdfContent drawn(letters);
    drawPattern(drawn, drawing, pattern, kinds, isProjected ? kOnScreen : SheetLineWidths{});
    const std::vector<Sheet> sheets = sheetsOf(drawing, *plan, isProjected, letters);
    const std::string texts = letters.addTo(file, fonts);
    const std::string common =
        "/Font << " + fonts + " >> /Properties <<" + listed.properties + " >> /XObject <<" + texts;
    const std::string extent = pdfNumber(drawing.width + 2 * kPageMargin) + " " +
                               pdfNumber(drawing.height + 2 * kPageMargin);
    const int form = file.addStream(
        "/Type /XObject /Subtype /Form /BBox [" + pdfNumber(-2 * kPageMargin) + " " +
            pdfNumber(-2 * kPageMargin) + " " + extent + "] /Resources << " + common + " >> >>",
        drawn.take());
    const Shared shared{file.reserve(), pdfReference(file.add("<< " + common + " /P " +
                                                              pdfReference(form) + " >> >>"))};
    std::vector<int> pages;
    for (const Sheet& sheet : sheets) {
        addPage(file, shared, pages, sheet);
    }
    file.set(shared.pages, "<< /Type /Pages /Count " + std::to_string(pages.size()) + " /Kids " +
                               references(pages) + " >>");
    file.set(catalog, "<< /Type /Catalog /Pages " + pdfReference(shared.pages) +
                          " /PageMode /UseOC /ViewerPreferences << /PrintScaling /None "
                          "/DisplayDocTitle true /PickTrayByPDFSize true >> /PageLabels " +
                          pageLabels(*plan) + " /OCProperties " + listed.listing + " >>");
    return file.finished(catalog, info);
}

}  // namespace toile
