// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace toile {

/// What a drawing's layer holds; each writer knows its name and colour for it.
enum class LayerKind { Cut, Sew, Notches, Internal, Marks, Grain, Text, Check };

/// Every kind, in the order in which layers are written. Those of the seam line, the notches, what
/// is inside and the grain are left out where nothing is on them.
inline constexpr std::array kLayerKinds{LayerKind::Cut,      LayerKind::Sew,   LayerKind::Notches,
                                        LayerKind::Internal, LayerKind::Marks, LayerKind::Grain,
                                        LayerKind::Text,     LayerKind::Check};

}  // namespace toile
