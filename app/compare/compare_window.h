// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <array>
#include <optional>
#include <vector>

#include "app/compare/method_comparison.h"
#include "app/render/scene_renderer.h"
#include "app/views/canvas.h"
#include "core/project/place_pieces.h"

class QComboBox;
class QLabel;
class QPushButton;
class QStackedWidget;
class QTableWidget;

namespace toile::app {

class ColourBar;

/// A picture of one flat piece that shares its camera with its neighbours. A double click frames
/// the whole piece.
class ComparedPicture : public RenderedWidget {
    Q_OBJECT

public:
    ComparedPicture(SheetCamera& camera, bool hasScaleBar, QWidget* parent);

    void setContent(SceneContent content, const ViewState& view);

protected:
    void paintGL() override;
    void resizeEvent(QResizeEvent* event) override;
    bool event(QEvent* event) override {
        return canvas_.handle(*event) || RenderedWidget::event(event);
    }

private:
    SheetCamera& camera_;
    Canvas canvas_;
    ViewState view_{};
    bool hasScaleBar_;
};

/// Compares the selected piece for four methods in a table with one column each: a picture, at a
/// common scale, and figures. Non-modal; follows the document and stops when closed.
class CompareWindow : public QDialog {
    Q_OBJECT

public:
    /// QString: a cell's text without the star.
    static constexpr int PlainRole = Qt::UserRole;

    /// @param ordinary  jobs of the window, which take precedence
    CompareWindow(Document& document, const JobRunner& ordinary, QWidget* parent);
    ~CompareWindow() override;

    MethodComparison& comparison() { return comparison_; }
    const SheetCamera& camera() const { return camera_; }

signals:
    /// The user wants to flatten the garment by this method.
    void methodWanted(toile::Method method);

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    static constexpr int kMethods = 4;

    /// The widgets of one method.
    struct Column {
        QComboBox* method = nullptr;
        QStackedWidget* pages = nullptr;
        QLabel* message = nullptr;           ///< replaces the picture if there is none
        ComparedPicture* picture = nullptr;  ///< null if this computer cannot draw
        QPushButton* use = nullptr;
        /// Moves `result` onto `reference`; cached, because it visits every vertex.
        std::optional<FlatMotion> motion{};
        std::shared_ptr<const PieceResult> result{}, reference{};
    };

    void makeTable();
    void makeColumn(int number, bool canDraw);
    void chooseMethods();
    void refresh();
    void showFigure(int row, const CriterionTraits& criterion);
    void showPictures();
    /// @return box around the piece on the sheet; empty if there is none
    Eigen::AlignedBox2d showPicture(Column& column, const MethodComparison::Entry& entry,
                                    SceneContent content, const ViewState& view);
    SheetPlace placeOver(Column& column, const std::shared_ptr<const PieceResult>& result) const;
    QString copiedFigures() const;

    Document& document_;
    SheetCamera camera_;
    MethodComparison comparison_;
    std::array<Column, kMethods> columns_{};
    bool isChosen_ = false;  ///< the user has chosen a method
    int shownPiece_ = -1;
    QTableWidget* table_;
    ColourBar* legend_;
};

}  // namespace toile::app
