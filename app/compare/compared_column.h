// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "app/compare/compared_picture.h"
#include "app/compare/method_comparison.h"
#include "app/compare/same_place.h"

class QLabel;
class QPushButton;
class QStackedWidget;

namespace toile {

/// One method of the comparison: its name, the piece as it makes it or a sentence why not, and a
/// button that takes the method over.
class ComparedColumn : public QWidget {
    Q_OBJECT

public:
    /// @param camera  null where this computer cannot draw: there is no picture then
    ComparedColumn(LinkedCamera* camera, int number, QWidget* parent = nullptr);

    /// @param inUse      whether the document has this method
    /// @param reference  as SamePlace::of
    void show(const MethodComparison::Entry& entry, bool inUse,
              const std::shared_ptr<const PieceResult>& reference, const PieceSettings& settings);
    /// Null where this computer cannot draw.
    ComparedPicture* picture() const { return picture_; }
    /// Around the piece on the sheet; empty where there is none.
    const Eigen::AlignedBox2d& box() const { return box_; }

signals:
    void used(toile::Method method);

private:
    QString message(const MethodComparison::Entry& entry) const;

    Method method_ = Method::Isometric;
    SamePlace place_;
    Eigen::AlignedBox2d box_;
    QLabel* name_;
    QStackedWidget* pages_;
    QLabel* message_;
    ComparedPicture* picture_ = nullptr;
    QPushButton* use_;
};

}  // namespace toile
