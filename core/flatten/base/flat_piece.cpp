// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flatten/base/flat_piece.h"

#include <algorithm>
#include <array>

namespace toile {
namespace {

constexpr std::array<MethodTraits, 8> kMethods = {{
    {Method::Isometric, "isometric", "Seam lengths exact, least distortion, no flips", true, false},
    {Method::Curvature, "curvature", "Seam lengths exact, angles where the curvature is", true,
     true},
    {Method::Wang2005, "wang2005", "Seam lengths exact, angles spread evenly (Wang 2005)", true,
     true},
    {Method::Stretch, "stretch", "Seam lengths on a circle, least stretch inside (Yoshizawa 2004)",
     true, false},
    {Method::Natural, "natural", "Free outline, conformal (Desbrun 2002)", false, false},
    {Method::Lscm, "lscm", "Free outline, least squares conformal (Levy 2002)", false, false},
    {Method::Abf, "abf", "Free outline, angle based (Sheffer 2005)", false, false},
    {Method::Convex, "convex", "Seam lengths on a circle, never flips (Tutte)", true, false},
}};

}  // namespace

std::span<const MethodTraits> allMethods() {
    return kMethods;
}

const MethodTraits& traits(Method method) {
    return *std::ranges::find(kMethods, method, &MethodTraits::method);
}

std::string_view name(Method method) {
    return traits(method).name;
}

std::optional<Method> parseMethod(std::string_view text) {
    const auto* found = std::ranges::find(kMethods, text, &MethodTraits::name);
    return found == kMethods.end() ? std::nullopt : std::optional(found->method);
}

}  // namespace toile
