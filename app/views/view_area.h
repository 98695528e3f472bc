// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "app/render/overlay_figures.h"
#include "app/render/overlay_values.h"
#include "app/views/tool.h"

class QSplitter;

namespace toile::app {

class ColourBar;
class Document;
class GarmentView;
class MorphBar;
class OverlayWatcher;
class PatternView;
class SceneView;
class SewnBar;
class ToolChoice;
class WalkBar;

/// Both views side by side, with the overlay's legend in a corner; a sentence in their place where
/// this computer cannot draw them.
class ViewArea : public QWidget {
    Q_OBJECT

public:
    ViewArea(Document& document, ToolChoice& tools, QWidget* parent = nullptr);

    /// Null where there is no OpenGL 3.3.
    GarmentView* garmentView() const { return garmentView_; }
    PatternView* patternView() const { return patternView_; }

    /// The view that the pointer was in last.
    ViewKind viewInUse() const { return viewInUse_; }
    /// Moves the keyboard there, where there are views, or to another.
    void takeKeyboard() { takeKeyboard(viewInUse_); }
    void takeKeyboard(ViewKind view);
    /// The slider from the garment to the pattern; null where there is no OpenGL 3.3.
    MorphBar* morphBar() const { return morphBar_; }
    /// The slider from the design to the pattern as sewn; null where there is no OpenGL 3.3.
    SewnBar* sewnBar() const { return sewnBar_; }
    /// The walk along the selected seam; null where there is no OpenGL 3.3.
    WalkBar* walkBar() const { return walkBar_; }

    void frameSelection();
    /// Shows both sides of the selected seam.
    void frameSeam();
    /// Shows a place of a flat piece from near by, with a ring around it.
    void showSpot(const WorstSpot& spot);
    /// The place with the ring, if any.
    std::optional<WorstSpot> shownSpot() const;
    /// Paints both views again, in what the render style is now.
    void repaintViews();
    /// True once both views show the present scene.
    bool isUpToDate() const;
    /// The place under the pointer, of either view; its value is shown on the colour bar.
    void showValueAt(const std::optional<SurfaceHit>& place);

signals:
    /// The pointer has come into a view, maybe another.
    void entered();
    /// The overlay's figures could not be worked out.
    void failed(const QString& sentence);

private:
    void makeViews();
    void showFigures();
    void showPointedValue();

    Document& document_;
    ToolChoice& tools_;
    QSplitter* splitter_;
    OverlayWatcher* figures_;
    ColourBar* legend_ = nullptr;
    GarmentView* garmentView_ = nullptr;
    PatternView* patternView_ = nullptr;
    std::vector<SceneView*> views_;  ///< both, or none
    MorphBar* morphBar_ = nullptr;
    SewnBar* sewnBar_ = nullptr;
    WalkBar* walkBar_ = nullptr;
    std::optional<SurfaceHit> pointed_;
    ViewKind viewInUse_ = ViewKind::Garment;
};

}  // namespace toile::app
