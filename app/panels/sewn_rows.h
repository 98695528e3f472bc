// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <optional>

#include "app/document/line_facts.h"

class QGridLayout;
class QLabel;
class QToolButton;
class QWidget;

namespace toile::app {

class Document;
class FieldGuard;
class PercentEdit;

/// The rows of the form of a segment that are about the seam that it is part of: the ease that is
/// meant, and its notches.
class SewnRows : public QObject {
    Q_OBJECT

public:
    SewnRows(Document& document, FieldGuard& guard, QWidget* form);

    /// @return the next free row
    int addTo(QGridLayout& grid, int row);
    void show(const Segment& segment);
    /// Shows that there is nothing.
    void clear();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void setEase(std::optional<double> ease);
    void addNotch();
    void removeNotch();

    Document& document_;
    PercentEdit* ease_;
    QToolButton *asWorn_, *add_, *remove_;
    QLabel* notches_;
    int seam_ = -1;  ///< that is sewn; -1: none is shown
    int gesture_ = -1;
};

}  // namespace toile::app
