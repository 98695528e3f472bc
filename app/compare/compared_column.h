// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "app/compare/compared_picture.h"
#include "app/compare/method_comparison.h"
#include "core/project/place_pieces.h"

class QLabel;
class QPushButton;
class QStackedWidget;

namespace toile::app {

/// What all methods of a comparison are shown by.
struct ComparisonGround {
    Method inUse = Method::Isometric;  ///< of the document
    /// Of the piece as the document has it.
    PieceSettings settings{};
    /// What the settings are about; may be null or not flat: then a piece lies as if they were
    /// about itself.
    std::shared_ptr<const PieceResult> reference{};
    PictureLook look{};
    bool isStopped = false;  ///< the comparison
};

/// One method of the comparison: its name, the piece as it makes it or a sentence why not, and a
/// button that takes the method over.
class ComparedColumn : public QWidget {
    Q_OBJECT

public:
    /// @param camera  null where this computer cannot draw: there is no picture then
    ComparedColumn(LinkedCamera* camera, int number, QWidget* parent = nullptr);

    void show(const MethodComparison::Entry& entry, const ComparisonGround& ground);
    /// Around the piece on the sheet; empty where there is none.
    const Eigen::AlignedBox2d& box() const { return box_; }

signals:
    void used(toile::Method method);

private:
    /// Where the result lies so that it covers the reference, as well as two shapes can: flat
    /// coordinates of two methods have nothing in common.
    SheetPlace placeOver(const std::shared_ptr<const PieceResult>& result,
                         const ComparisonGround& ground);
    static QString message(const MethodComparison::Entry& entry, bool isStopped);

    Method method_ = Method::Isometric;
    /// Between these two, which takes a look at every vertex.
    std::optional<FlatMotion> motion_;
    std::shared_ptr<const PieceResult> result_, reference_;
    Eigen::AlignedBox2d box_;
    QLabel* name_;
    QStackedWidget* pages_;
    QLabel* message_;
    ComparedPicture* picture_ = nullptr;  ///< null where this computer cannot draw
    QPushButton* use_;
};

}  // namespace toile::app
