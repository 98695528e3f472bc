// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFontMetrics>
#include <QLabel>

namespace toile::app {

/// As many whole clauses of "Click: select · Drag: turn · Wheel: zoom", from the first on, as fit
/// into a width in pixels; an ellipsis stands for the rest.
QString fittingClauses(const QString& text, const QFontMetrics& metrics, int width);

/// One line of a status bar that never ends in mid-word: clauses that do not fit are left out, and
/// the tool tip has them all.
class HintLabel : public QLabel {
    Q_OBJECT

public:
    explicit HintLabel(QWidget* parent = nullptr);

    /// Sets the text and its tool tip.
    void setHint(const QString& text);

protected:
    void paintEvent(QPaintEvent* event) override;
};

}  // namespace toile::app
