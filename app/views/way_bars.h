// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "app/views/play_bar.h"

namespace toile {
struct Proof;
}  // namespace toile

namespace toile::app {

class Document;
class GarmentView;

/// The way from the garment to the pattern, at the foot of the garment view. Hidden where nothing
/// is flat.
class MorphBar : public PlayBar {
    Q_OBJECT

public:
    /// @param view  where it lies; owns it
    MorphBar(Document& document, GarmentView& view);

private:
    void showOrHide();

    Document& document_;
};

/// The way from the design to the pattern sewn back together, over the bar of the way to the
/// pattern: of the two ways the garment goes one at a time. Hidden where nothing is sewn.
class SewnBar : public PlayBar {
    Q_OBJECT

public:
    /// @param view  where it lies; owns it
    SewnBar(Document& document, GarmentView& view, MorphBar& morph);

private:
    void showOrHide();

    Document& document_;
    MorphBar& morph_;
    bool isThere_ = false;
    std::shared_ptr<const Proof> seen_;  ///< shown last
    int left_ = 0;                       ///< where the slider stood then
};

}  // namespace toile::app
