// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QToolButton>

namespace toile::app {

/// Shows a colour; a click chooses another, or the usual one again.
class ColourButton : public QToolButton {
    Q_OBJECT

public:
    explicit ColourButton(QWidget* parent = nullptr);

    /// Invalid: the usual one.
    QColor colour() const { return colour_; }
    void setColour(const QColor& colour);

signals:
    /// By the person; not by setColour.
    void colourChosen(const QColor& colour);

private:
    void choose(const QColor& colour);

    QColor colour_;
};

}  // namespace toile::app
