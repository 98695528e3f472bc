// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/compare/same_place.h"

#include <utility>

namespace toile {

SheetPlace SamePlace::of(const std::shared_ptr<const PieceResult>& result,
                         const std::shared_ptr<const PieceResult>& reference,
                         PieceSettings settings) {
    if (result != result_ || reference != reference_) {
        result_ = result;
        reference_ = reference;
        motion_ = flatMotions({reference}, {result}).front();
    }
    settings.anchors.clear();
    settings.placement = settings.placement.value_or(Placement{});
    if (motion_) {
        settings = movedSettings(std::move(settings), motion_->oldOfNew, motion_->reach);
    }
    return placesOf({settings}).front();
}

}  // namespace toile
