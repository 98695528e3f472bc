// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/format_options.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "core/base/setting.h"
#include "core/base/text.h"
#include "core/formats/formats.h"

namespace toile {
namespace {

constexpr const char* kSwitch[] = {"off", "on"};
constexpr const char* kDxfProfiles[] = {"astm", "aama", "plain"};
constexpr const char* kDxfProfileNames[] = {TR("ASTM D6673"), TR("ANSI/AAMA-292"),
                                            TR("Plain drawing")};
constexpr const char* kDxfUnits[] = {"mm", "cm", "in"};
constexpr const char* kDxfUnitNames[] = {TR("Millimetres"), TR("Centimetres"), TR("Inches")};
constexpr LengthUnit kUnits[] = {LengthUnit::Millimetre, LengthUnit::Centimetre, LengthUnit::Inch};
constexpr const char* kPapers[] = {"a4",     "letter",   "tile",     "a0",       "arch-d",
                                   "arch-e", "roll-610", "roll-841", "roll-914", "projector"};
constexpr const char* kPaperNames[] = {
    TR("A4 tiles"),     TR("Letter tiles"), TR("Tiles for A4 and Letter"),
    TR("A0"),           TR("Arch D"),       TR("Arch E"),
    TR("Roll, 610 mm"), TR("Roll, 841 mm"), TR("Roll, 914 mm"),
    TR("Projector")};
constexpr const char* kSvgPresets[] = {"inkscape", "illustrator", "silhouette", "laser", "cricut"};
constexpr const char* kSvgPresetNames[] = {TR("Inkscape"), TR("Illustrator"), TR("Silhouette"),
                                           TR("Laser (LightBurn)"), TR("Cricut")};
constexpr const char* kSvgGroups[] = {"kind", "piece"};
constexpr const char* kSvgGroupNames[] = {TR("Layers by kind"), TR("Groups by piece")};
constexpr const char* kSvgTexts[] = {"text", "paths"};
constexpr const char* kSvgTextNames[] = {TR("Text"), TR("Outlines")};

constexpr const char* kMeshUvs[] = {"drawn", "exact"};
constexpr const char* kMeshUvNames[] = {TR("Drawn pattern"), TR("Exact outlines")};

constexpr const char* kDxfPresets[] = {"clo",    "accumark",    "optitex",
                                       "lectra", "illustrator", "laser"};
constexpr const char* kDxfPresetNames[] = {TR("CLO, Marvelous Designer"),
                                           TR("AccuMark"),
                                           TR("Optitex"),
                                           TR("Lectra"),
                                           TR("Illustrator"),
                                           TR("Laser cutter")};
/// In the order of the presets. For the profiles, the only known requirement of these programs is
/// the unit: CLO writes its METRIC files in millimetres, AccuMark works in inches and reads METRIC
/// in more than one way, and Optitex reads METRIC as centimetres. Lectra has accepted boundaries as
/// polylines in an AAMA file, and refused them in an ASTM one. Drawing programs and lasers use
/// named layers and no blocks.
constexpr DxfOptions kOfPresets[] = {
    {DxfProfile::Astm, LengthUnit::Millimetre},  {DxfProfile::Astm, LengthUnit::Inch},
    {DxfProfile::Astm, LengthUnit::Centimetre},  {DxfProfile::Aama, LengthUnit::Millimetre},
    {DxfProfile::Plain, LengthUnit::Millimetre}, {DxfProfile::Plain, LengthUnit::Millimetre}};
static_assert(std::size(kOfPresets) == std::size(kDxfPresets));

/// The words are in the order of the values.
template <class Value, std::size_t n>
bool choose(const char* const (&words)[n], std::string_view typed, Value& value) {
    const auto at = std::ranges::find(words, typed);
    if (at == std::end(words)) {
        return false;
    }
    value = static_cast<Value>(at - std::begin(words));
    return true;
}

template <class Value, std::size_t n>
std::string chosen(const char* const (&words)[n], Value value) {
    return words[static_cast<std::size_t>(value)];
}

std::string dxfPreset(const ExportOptions& options) {
    DxfOptions own = options.dxf;
    own.ruleTable = own.controlPiece = false;  // in no preset
    const auto at = std::ranges::find(kOfPresets, own);
    return at == std::end(kOfPresets) ? "" : kDxfPresets[at - std::begin(kOfPresets)];
}

bool setDxfPreset(ExportOptions& options, std::string_view typed) {
    std::size_t preset = 0;
    if (!choose(kDxfPresets, typed, preset)) {
        return false;
    }
    options.dxf.profile = kOfPresets[preset].profile;
    options.dxf.unit = kOfPresets[preset].unit;
    return true;
}

std::string dxfUnit(const ExportOptions& options) {
    return kDxfUnits[std::ranges::find(kUnits, options.dxf.unit) - std::begin(kUnits)];
}

bool setDxfUnit(ExportOptions& options, std::string_view typed) {
    std::size_t unit = 0;
    if (!choose(kDxfUnits, typed, unit)) {
        return false;
    }
    options.dxf.unit = kUnits[unit];
    return true;
}

bool setNumber(double& value, std::string_view typed, double least, double most) {
    double read = 0;
    const auto [end, error] = std::from_chars(typed.data(), typed.data() + typed.size(), read);
    if (error != std::errc() || end != typed.data() + typed.size() || !std::isfinite(read) ||
        read < least || read > most) {
        return false;
    }
    value = read;
    return true;
}

constexpr double kMaxOverlap = 50;  // mm
constexpr double kMinDpi = 10, kMaxDpi = 1200;

using Options = ExportOptions;
using Typed = std::string_view;

constexpr FormatId kForDxf[] = {FormatId::Dxf}, kForPdf[] = {FormatId::Pdf},
                   kForSvg[] = {FormatId::Svg}, kForPlt[] = {FormatId::Plt},
                   kForPng[] = {FormatId::Png}, kForObj[] = {FormatId::Obj},
                   kForMeshes[] = {FormatId::Obj, FormatId::Usd, FormatId::Glb};

const FormatOption kRows[] = {
    {.formats = kForDxf,
     .name = "dxf-preset",
     .title = TR("Program"),
     .help = TR("Program that opens the DXF file; sets profile and unit"),
     .words = kDxfPresets,
     .names = kDxfPresetNames,
     .get = dxfPreset,
     .set = setDxfPreset},
    {.formats = kForDxf,
     .name = "dxf-profile",
     .title = TR("Profile"),
     .help = TR("ASTM D6673 or ANSI/AAMA-292 for pattern programs, plain for drawing and cutting"),
     .words = kDxfProfiles,
     .names = kDxfProfileNames,
     .get = [](const Options& o) { return chosen(kDxfProfiles, o.dxf.profile); },
     .set = [](Options& o, Typed typed) { return choose(kDxfProfiles, typed, o.dxf.profile); }},
    {.formats = kForDxf,
     .name = "dxf-unit",
     .title = TR("Unit"),
     .help = TR("Unit of the numbers in the DXF file"),
     .words = kDxfUnits,
     .names = kDxfUnitNames,
     .get = dxfUnit,
     .set = setDxfUnit},
    {.formats = kForDxf,
     .name = "dxf-rul",
     .title = TR("Rule table"),
     .help = TR("Also write a rule table of one size (.rul)"),
     .words = kSwitch,
     .isSwitch = true,
     .get = [](const Options& o) { return chosen(kSwitch, o.dxf.ruleTable); },
     .set = [](Options& o, Typed typed) { return choose(kSwitch, typed, o.dxf.ruleTable); }},
    {.formats = kForDxf,
     .name = "dxf-control-piece",
     .title = TR("Control piece"),
     .help = TR("Add a square of 100 mm as an extra piece, to check the scale"),
     .words = kSwitch,
     .isSwitch = true,
     .get = [](const Options& o) { return chosen(kSwitch, o.dxf.controlPiece); },
     .set = [](Options& o, Typed typed) { return choose(kSwitch, typed, o.dxf.controlPiece); }},
    {.formats = kForPdf,
     .name = "paper",
     .title = TR("Paper"),
     .help = TR("Paper of the PDF file: tiles of a4, letter or tile, which fits both; one page of "
                "a0, arch-d or arch-e; a roll; or projector"),
     .words = kPapers,
     .names = kPaperNames,
     .get = [](const Options& o) { return chosen(kPapers, o.pdf.paper); },
     .set = [](Options& o, Typed typed) { return choose(kPapers, typed, o.pdf.paper); }},
    {.formats = kForPdf,
     .name = "overlap",
     .title = TR("Overlap"),
     .help = TR("Overlap of the tiles of a PDF file, mm"),
     .least = 0,
     .most = kMaxOverlap,
     .get = [](const Options& o) { return shortest(o.pdf.overlap); },
     .set = [](Options& o,
               Typed typed) { return setNumber(o.pdf.overlap, typed, 0, kMaxOverlap); }},
    {.formats = kForSvg,
     .name = "svg-preset",
     .title = TR("Program"),
     .help = TR("Program or machine that opens the SVG file"),
     .words = kSvgPresets,
     .names = kSvgPresetNames,
     .get = [](const Options& o) { return chosen(kSvgPresets, o.svg.preset); },
     .set = [](Options& o, Typed typed) { return choose(kSvgPresets, typed, o.svg.preset); }},
    {.formats = kForSvg,
     .name = "svg-groups",
     .title = TR("Groups"),
     .help = TR("A layer for each kind of line, or a group for each piece"),
     .words = kSvgGroups,
     .names = kSvgGroupNames,
     .get = [](const Options& o) { return chosen(kSvgGroups, o.svg.groups); },
     .set = [](Options& o, Typed typed) { return choose(kSvgGroups, typed, o.svg.groups); }},
    {.formats = kForSvg,
     .name = "svg-text",
     .title = TR("Text"),
     .help = TR("Write text as text, or as outlines of its letters"),
     .words = kSvgTexts,
     .names = kSvgTextNames,
     .get = [](const Options& o) { return chosen(kSvgTexts, o.svg.textAsPaths); },
     .set = [](Options& o, Typed typed) { return choose(kSvgTexts, typed, o.svg.textAsPaths); }},
    {.formats = kForPlt,
     .name = "plt-turned",
     .title = TR("Turned"),
     .help = TR("Turn the plot by 90°"),
     .words = kSwitch,
     .isSwitch = true,
     .get = [](const Options& o) { return chosen(kSwitch, o.plt.turned); },
     .set = [](Options& o, Typed typed) { return choose(kSwitch, typed, o.plt.turned); }},
    {.formats = kForPng,
     .name = "png-dpi",
     .title = TR("Dots per inch"),
     .help = TR("Dots per inch of the PNG picture"),
     .least = kMinDpi,
     .most = kMaxDpi,
     .get = [](const Options& o) { return shortest(o.png.dpi); },
     .set = [](Options& o, Typed typed) { return setNumber(o.png.dpi, typed, kMinDpi, kMaxDpi); }},
    {.formats = kForMeshes,
     .name = "mesh-uv",
     .title = TR("Pattern"),
     .help =
         TR("Texture coordinates of OBJ, USD and GLB files: the drawn pattern, or exact outlines"),
     .words = kMeshUvs,
     .names = kMeshUvNames,
     .get = [](const Options& o) { return chosen(kMeshUvs, o.mesh.isExact); },
     .set = [](Options& o, Typed typed) { return choose(kMeshUvs, typed, o.mesh.isExact); }},
    {.formats = kForObj,
     .name = "obj-pieces",
     .title = TR("A file for each piece"),
     .help = TR("Also write each piece to its own OBJ file"),
     .words = kSwitch,
     .isSwitch = true,
     .get = [](const Options& o) { return chosen(kSwitch, o.mesh.eachPiece); },
     .set = [](Options& o, Typed typed) { return choose(kSwitch, typed, o.mesh.eachPiece); }},
};

}  // namespace

std::span<const FormatOption> formatOptions() {
    return kRows;
}

}  // namespace toile
