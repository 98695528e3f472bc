// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/dart_edits.h"

#include <map>
#include <utility>

#include "core/pattern/dart_places.h"
#include "core/seam/seam_settings.h"

namespace toile::app {

namespace {

const Seam& seamOf(const Garment& garment, int dart) {
    return garment.seams.seams[static_cast<std::size_t>(dart)];
}

LineSettings withDart(LineSettings lines, const Garment& garment, int dart, DartSettings said) {
    std::erase_if(lines.darts, [&](const DartSettings& one) -> bool {
        return seamAt(garment.seams, one.seam) == dart;
    });
    said.seam = seamOf(garment, dart).place;
    if (!said.saysNothing()) {
        lines.darts.push_back(said);
    }
    return lines;
}

/// The other dart that mirrors one.
std::optional<int> imageOf(const Garment& garment, int dart, const Symmetry* symmetry) {
    const auto at = static_cast<std::size_t>(dart);
    if (!symmetry || at >= symmetry->lengths.mirrored.size()) {
        return std::nullopt;
    }
    const int image = symmetry->lengths.mirrored[at];
    return image >= 0 && image != dart && seamOf(garment, image).kind == SeamKind::Dart
               ? std::optional(image)
               : std::nullopt;
}

/// With a field of what is said of a dart at one value, and of the dart that mirrors it at another.
template <class Value>
LineSettings withField(LineSettings lines, const Garment& garment, int dart,
                       Value DartSettings::*field, const Value& value, const Value& mirrored,
                       const Symmetry* symmetry) {
    DartSettings said = saidOfDart(garment, lines, dart);
    said.*field = value;
    lines = withDart(std::move(lines), garment, dart, said);
    if (const auto image = imageOf(garment, dart, symmetry)) {
        DartSettings there = saidOfDart(garment, lines, *image);
        there.*field = mirrored;
        lines = withDart(std::move(lines), garment, *image, there);
    }
    return lines;
}

/// Outlines that mirror each other run in opposite senses.
DartLay mirroredLay(DartLay lay) {
    return lay == DartLay::First ? DartLay::Second : DartLay::First;
}

}  // namespace

DartSettings saidOfDart(const Garment& garment, const LineSettings& lines, int dart) {
    const std::map<int, DartSettings> said = statedDarts(garment.seams, lines);
    const auto found = said.find(dart);
    return found != said.end() ? found->second : DartSettings{};
}

LineSettings withIntake(LineSettings lines, const Garment& garment, int dart,
                        std::optional<double> intake, const Symmetry* symmetry) {
    return withField(std::move(lines), garment, dart, &DartSettings::intake, intake, intake,
                     symmetry);
}

LineSettings withLay(LineSettings lines, const Garment& garment, int dart,
                     std::optional<DartLay> lay, const Symmetry* symmetry) {
    return withField(std::move(lines), garment, dart, &DartSettings::lay, lay,
                     lay ? std::optional(mirroredLay(*lay)) : std::nullopt, symmetry);
}

}  // namespace toile::app
