// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/nest/nest.h"
#include "core/nest/random.h"

namespace toile::test {

geometry::Polygon nestPolygon(std::initializer_list<std::pair<double, double>> points);
geometry::Polygon nestRectangle(double width, double height);
NestItem nestItem(const std::string& name, const geometry::Polygon& outline, int demand = 1);

/// A ring of `count` points about the origin, concave as a rule, seen from there in full.
geometry::Polygon nestStar(nest::Random& random, int count, double least, double most);

/// Expects all that a nest promises: each copy there, at an angle that it may have, in the strip,
/// the gap from all others.
void expectKeepsRules(const NestInstance& instance, const NestOptions& options,
                      const NestResult& result);

}  // namespace toile::test
