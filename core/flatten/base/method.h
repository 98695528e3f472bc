// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace toile {

/// A published way of flattening. docs/methods.md compares them.
enum class Method {
    Isometric,  ///< boundary lengths kept exactly, the rest as isometric as they allow, no flips
    Curvature,  ///< boundary lengths kept exactly, angles placed by the curvature, conformal inside
    Wang2005,   ///< boundary lengths kept exactly, angles evenly, conformal interior [Wang05]
    Stretch,    ///< edge lengths kept on a circle, interior of least stretch [YBS04]
    Natural,    ///< free boundary, conformal [DMA02]; seam lengths are not kept
    Lscm,       ///< free boundary, least squares conformal [LPRM02]; seam lengths are not kept
    Abf,        ///< free boundary, angle based [SLMB05]; seam lengths are not kept
    Convex,     ///< edge lengths kept on a circle, interior without flips [Flo03]
};

/// What the command line, the report and the window need to know of a method.
struct MethodTraits {
    Method method;
    std::string_view name;     ///< one word, as typed: "wang2005"
    std::string_view summary;  ///< a line for a list, no full stop
    bool keepsLengths;         ///< every boundary edge has its 3D length
    bool solvesBoundary;       ///< uses the boundary problem of [Wang05] eq. (9)
};

/// All methods, the one recommended first.
std::span<const MethodTraits> allMethods();
const MethodTraits& traits(Method method);
std::string_view name(Method method);
std::optional<Method> parseMethod(std::string_view text);

}  // namespace toile
