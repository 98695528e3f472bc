// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/stated_options.h"

#include <utility>

namespace toile::app {

FlattenOptions StatedOptions::over(FlattenOptions options) const {
    options.method = method.value_or(options.method);
    options.quality = quality.value_or(options.quality);
    options.boundarySolver = boundarySolver.value_or(options.boundarySolver);
    options.freeBoundary = freeBoundary.value_or(options.freeBoundary);
    options.stretchOutline = stretchOutline.value_or(options.stretchOutline);
    options.authalic = authalic.value_or(options.authalic);
    return options;
}

LineSettings StatedOptions::over(LineSettings lines) const {
    if (fairing || (trueSeams && !lines.fairing)) {
        lines.fairing = fairing.value_or(Fairing{});
    }
    lines.trueBelow = trueSeams ? kProposedTrueing : lines.trueBelow;
    const bool asksForMirror = byHalf && lines.mirror == Mirror::None;
    lines.mirror = asksForMirror ? Mirror::Mean : lines.mirror;
    if (pattern) {
        lines = withPattern(std::move(lines));
    }
    lines.mirror = mirror.value_or(lines.mirror);
    lines.grain = grain ? grain : lines.grain;
    lines.label.size = size.value_or(lines.label.size);
    lines.label.date = date.value_or(lines.label.date);
    if (allowance || hem) {
        const AllowanceWidths before = lines.allowance.value_or(AllowanceWidths{});
        lines.allowance = {allowance.value_or(before.seam), hem.value_or(before.hem)};
    }
    if (notches) {
        lines.notches =
            *notches ? lines.notches.value_or(NotchRules{}) : std::optional<NotchRules>();
        if (lines.notches) {
            lines.notches->automatic = true;
        }
    }
    return lines;
}

}  // namespace toile::app
