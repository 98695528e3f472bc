// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/formats.h"

#include <algorithm>

#include "core/base/file.h"
#include "core/base/setting.h"
#include "core/base/text.h"
#include "core/formats/dxf/apparel_dxf.h"
#include "core/formats/garmentcode/garmentcode_writer.h"
#include "core/formats/mesh/piece_meshes.h"
#include "core/formats/pdf/pdf_writer.h"
#include "core/formats/read_backs.h"
#include "core/formats/tables/report_tables.h"
#include "core/formats/writers.h"

namespace toile {
namespace {

ExportedFiles oneFile(std::string bytes) {
    return {{"", std::move(bytes)}};
}

Result<ExportedFiles> makeSvg(const ExportSource& source) {
    return oneFile(writeSvg(source.drawing(), source.options().svg));
}

Result<ReadBack> readSvgFile(const ExportedFiles& files, const ExportSource& source) {
    return readBackSvg(files.front().bytes, source.drawing(), source.options().svg);
}

Result<ExportedFiles> makeDxf(const ExportSource& source) {
    const DxfOptions& options = source.options().dxf;
    if (options.profile == DxfProfile::Plain) {
        return oneFile(writePlainDxf(source.drawing(), options.unit));
    }
    ExportedFiles files = oneFile(writeApparelDxf(source));
    if (options.ruleTable) {
        files.push_back({".rul", writeRuleTable(source)});
    }
    return files;
}

Result<ExportedFiles> makePdf(const ExportSource& source) {
    return writePdf(source.drawing(), source.laid().pattern, source.options().pdf)
        .andThen([](std::string made) { return Result(oneFile(std::move(made))); });
}

Result<ExportedFiles> makePlt(const ExportSource& source) {
    return oneFile(writePlt(source.drawing(), source.options().plt));
}

Result<ReadBack> readPngFile(const ExportedFiles& files, const ExportSource& source) {
    return readBackPng(files.front().bytes, source.drawing(), source.options().png);
}

Result<ExportedFiles> makeReport(const ExportSource& source) {
    return oneFile(
        writeReport(source.garment(), source.results(), source.laid().pattern, source.fabric()));
}

Result<ReadBack> readReportBack(const ExportedFiles& files, const ExportSource& source) {
    return readBackReport(files.front().bytes, source.garment(), source.results());
}

Result<ExportedFiles> makeHtml(const ExportSource& source) {
    return oneFile(writeHtmlReport(source));
}

Result<ExportedFiles> makeCsv(const ExportSource& source) {
    const WalkedGarment walked = walkGarment(source.garment(), source.results(),
                                             source.laid().pattern, source.lines().notches);
    ExportedFiles files = oneFile(writeCsv(pieceTable(source.laid().pattern, source.results())));
    std::vector<ReportTable> tables{ledgerTable(source.garment(), source.results()),
                                    walkTable(source.garment(), walked.notches, walked.walks)};
    if (ReportTable edges = edgeTable(source.laid().pattern); !edges.rows.empty()) {
        tables.push_back(std::move(edges));
    }
    for (const ReportTable& table : tables) {
        files.push_back({"-" + table.slug + ".csv", writeCsv(table)});
    }
    return files;
}

/// Whether a pattern has lines that a UV map does not show.
bool isMoreThanOutlines(const Pattern& pattern) {
    return pattern.hasAllowance || pattern.hasNotches ||
           std::ranges::any_of(pattern.pieces, [](const PatternPiece& piece) {
               return !piece.internals.empty() || !piece.extensions.empty();
           });
}

/// The drawing of all pieces whole, as in a UV map; most drawings already are.
Drawing wholeDrawing(const ExportSource& source) {
    const LaidOutPattern& laid = source.laid();
    const bool isWhole = laid.wholePattern.facings.empty() &&
                         std::ranges::all_of(laid.pattern.pieces, [](const PatternPiece& piece) {
                             return piece.cutAs == CutAs::Whole;
                         });
    return isWhole ? source.drawing() : draw(laid.wholePattern, laid.whole, source.words());
}

Result<ExportedFiles> makeObj(const ExportSource& source) {
    const bool isExact = source.options().mesh.isExact;
    const PieceResults results = isExact ? exactResults(source.results()) : source.results();
    std::string obj = writeObj(source.garment(), results, source.laid().whole);
    if (!isExact && isMoreThanOutlines(source.laid().wholePattern)) {
        obj += writeObjLines(wholeDrawing(source),
                             millimetresPer(source.garment().files.front()->unit));
    }
    ExportedFiles files = oneFile(std::move(obj));
    if (source.options().mesh.eachPiece) {
        const PieceMeshes meshes = pieceMeshes(source);
        for (std::size_t k = 0; k < meshes.meshes.size(); ++k) {
            const auto file = static_cast<std::size_t>(source.garment().pieces[k]->file);
            files.push_back({"-" + meshes.meshes[k].slug + ".obj",
                             writePieceObj(meshes.meshes[k], *source.garment().files[file])});
        }
    }
    return files;
}

Result<ReadBack> readObjBack(const ExportedFiles& files, const ExportSource& source) {
    return comparedWithObj(files.front().bytes, source);
}

/// For a format of 3D programs.
template <auto write>
Result<ExportedFiles> makeMeshes(const ExportSource& source) {
    return oneFile(write(pieceMeshes(source), source.laid().pattern.name));
}

Result<ExportedFiles> makeGarmentCode(const ExportSource& source) {
    return oneFile(writeGarmentCode(sewnPanels(source)));
}

Result<ReadBack> readGarmentCodeBack(const ExportedFiles& files, const ExportSource& source) {
    return readBackGarmentCode(files.front().bytes, source.laid().wholePattern);
}

constexpr const char* kSvg[] = {".svg"};
constexpr const char* kDxf[] = {".dxf"};
constexpr const char* kPdf[] = {".pdf"};
constexpr const char* kPlt[] = {".plt", ".hpgl"};
constexpr const char* kPng[] = {".png"};
constexpr const char* kObj[] = {".obj"};
constexpr const char* kUsd[] = {".usda"};
constexpr const char* kGlb[] = {".glb"};
constexpr const char* kGarmentCode[] = {".specification.json"};
constexpr const char* kReport[] = {".json"};
constexpr const char* kHtml[] = {".html", ".htm"};
constexpr const char* kCsv[] = {".csv"};

Format kFormats[] = {
    Format{.id = FormatId::Svg,
           .name = TR("SVG drawing"),
           .use = TR("drawing programs, laser and blade cutters"),
           .endings = kSvg,
           .layers = true,
           .trueScale = true,
           .write = makeSvg,
           .readBack = readSvgFile},
    Format{.id = FormatId::Dxf,
           .name = TR("DXF pattern"),
           .use = TR("pattern programs, CAD and cutting machines"),
           .endings = kDxf,
           .layers = true,
           .trueScale = true,
           .write = makeDxf,
           .readBack = readDxfBack},
    Format{.id = FormatId::Pdf,
           .name = TR("PDF to print"),
           .use = TR("home printers, copy shops and projectors"),
           .endings = kPdf,
           .layers = true,
           .trueScale = true,
           .curves = true,
           .pages = true,
           .write = makePdf},
    Format{.id = FormatId::Plt,
           .name = TR("HPGL plot"),
           .use = TR("pen plotters and roll cutters"),
           .endings = kPlt,
           .layers = true,
           .trueScale = true,
           .write = makePlt},
    Format{.id = FormatId::Png,
           .name = TR("PNG picture"),
           .use = TR("e-mail and web pages, at a chosen resolution"),
           .endings = kPng,
           .trueScale = true,
           .readBack = readPngFile},
    Format{.id = FormatId::Obj,
           .name = TR("OBJ with UV map"),
           .use = TR("3D programs: the garment with its pattern as its texture"),
           .endings = kObj,
           .trueScale = true,
           .write = makeObj,
           .readBack = readObjBack},
    Format{.id = FormatId::Usd,
           .name = TR("USD scene"),
           .use = TR("film and simulation: garment, flat pattern and seams"),
           .endings = kUsd,
           .trueScale = true,
           .write = makeMeshes<writeUsda>},
    Format{.id = FormatId::Glb,
           .name = TR("GLB mesh"),
           .use = TR("games and web pages: the garment with its pattern as its texture"),
           .endings = kGlb,
           .trueScale = true,
           .write = makeMeshes<writeGlb>},
    Format{.id = FormatId::GarmentCode,
           .name = TR("GarmentCode pattern"),
           .use = TR("research and simulation: panels, curves and stitches"),
           .endings = kGarmentCode,
           .trueScale = true,
           .curves = true,
           .write = makeGarmentCode,
           .readBack = readGarmentCodeBack},
    Format{.id = FormatId::Html,
           .name = TR("HTML report"),
           .use = TR("reading and printing: the drawing with all measures"),
           .endings = kHtml,
           .write = makeHtml},
    Format{.id = FormatId::Csv,
           .name = TR("CSV tables"),
           .use = TR("spreadsheets: pieces, seams, free edges and the walk along them"),
           .endings = kCsv,
           .write = makeCsv},
    Format{.id = FormatId::Report,
           .name = TR("JSON report"),
           .use = TR("scripts: every figure of every piece"),
           .endings = kReport,
           .write = makeReport,
           .readBack = readReportBack},
};

}  // namespace

std::span<const Format> formats() {
    return kFormats;
}

const Format& formatOf(FormatId id) {
    return *std::ranges::find(kFormats, id, &Format::id);
}

std::string_view endingOf(const std::filesystem::path& path) {
    std::string name = pathText(path.filename());
    std::ranges::transform(name, name.begin(), lowered);
    std::string_view longest;
    for (const Format& format : kFormats) {
        for (const std::string_view ending : format.endings) {
            const bool fits = name.size() > ending.size() && name.ends_with(ending);
            longest = fits && ending.size() > longest.size() ? ending : longest;
        }
    }
    return longest;
}

const Format* formatOf(const std::filesystem::path& path) {
    const std::string_view ending = endingOf(path);
    const auto* const found = std::ranges::find_if(kFormats, [ending](const Format& format) {
        return std::ranges::find(format.endings, ending) != format.endings.end();
    });
    return found != std::end(kFormats) ? found : nullptr;
}

void provideWriter(FormatId id, Result<ExportedFiles> (*write)(const ExportSource&)) {
    std::ranges::find(kFormats, id, &Format::id)->write = write;
}

std::string writtenEndings() {
    std::vector<std::string> endings;
    for (const Format& format : kFormats) {
        if (format.write) {
            endings.emplace_back(format.endings.front());
        }
    }
    std::string text;
    for (std::size_t k = 0; k < endings.size(); ++k) {
        text += k == 0 ? "" : k + 1 == endings.size() ? " or " : ", ";
        text += endings[k];
    }
    return text;
}

}  // namespace toile
