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

/// Both views side by side, with the overlay's legend in a corner. Shows a message instead if this
/// computer cannot draw them.
class ViewArea : public QWidget {
    Q_OBJECT

public:
    ViewArea(Document& document, ToolChoice& tools, QWidget* parent = nullptr);

    /// Null without OpenGL 3.3.
    GarmentView* garmentView() const { return garmentView_; }
    PatternView* patternView() const { return patternView_; }

    /// The view that last contained the pointer.
    ViewKind viewInUse() const { return viewInUse_; }
    /// Gives the keyboard focus to that view, or to another if there are views.
    void takeKeyboard() { takeKeyboard(viewInUse_); }
    void takeKeyboard(ViewKind view);
    /// The slider from the garment to the pattern; null without OpenGL 3.3.
    MorphBar* morphBar() const { return morphBar_; }
    /// The slider from the design to the sewn pattern; null without OpenGL 3.3.
    SewnBar* sewnBar() const { return sewnBar_; }
    /// The walk along the selected seam; null without OpenGL 3.3.
    WalkBar* walkBar() const { return walkBar_; }

    void frameSelection();
    /// Frames both sides of the selected seam.
    void frameSeam();
    /// Frames a spot of a flat piece closely and rings it.
    void showSpot(const WorstSpot& spot);
    /// The ringed spot, if any.
    std::optional<WorstSpot> shownSpot() const;
    /// Repaints both views in the current render style.
    void repaintViews();
    /// True once both views show the current scene.
    bool isUpToDate() const;
    /// Shows the value at the pointer's place, from either view, on the colour bar.
    void showValueAt(const std::optional<SurfaceHit>& place);

signals:
    /// The pointer has entered a view.
    void entered();
    /// The overlay's figures could not be computed.
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
