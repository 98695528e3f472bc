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

/// The slider from garment to pattern, at the bottom of the garment view. Hidden if nothing is
/// flat.
class MorphBar : public PlayBar {
    Q_OBJECT

public:
    /// @param view  parent and owner
    MorphBar(Document& document, GarmentView& view);

private:
    void showOrHide();

    Document& document_;
};

/// The slider from the design to the pattern sewn back together, above the morph bar. Moving one
/// slider rewinds the other. Hidden if nothing is sewn.
class SewnBar : public PlayBar {
    Q_OBJECT

public:
    /// @param view  parent and owner
    SewnBar(Document& document, GarmentView& view, MorphBar& morph);

private:
    void showOrHide();

    Document& document_;
    MorphBar& morph_;
    bool isThere_ = false;
    std::shared_ptr<const Proof> seen_;  ///< the proof shown last
    int left_ = 0;                       ///< slider value when it was hidden
};

}  // namespace toile::app
