// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <functional>

#include "core/marker/marker_settings.h"

class QCheckBox;
class QComboBox;
class QGridLayout;
class QLabel;
class QSpinBox;

namespace toile::app {

class AngleEdit;
class FieldGuard;
class LengthEdit;
class MarkerDesk;

/// What is said of the cloth and of how the pieces may lie on it: one step of the history each, or
/// one for as long as a field is typed in.
class MarkerForm : public QWidget {
    Q_OBJECT

public:
    /// `desk` must outlive this.
    explicit MarkerForm(MarkerDesk& desk, QWidget* parent = nullptr);

    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    using Change = std::function<void(MarkerSettings&)>;

    void addCloth(QGridLayout& grid);
    void addPieces(QGridLayout& grid);
    void addStripes(QGridLayout& grid);
    LengthEdit* addLength(QGridLayout& grid, const char* name, const QString& title,
                          const QString& tip, double least, double most,
                          std::function<void(MarkerSettings&, double)> set);
    void addRow(QGridLayout& grid, const char* name, const QString& title, const QString& tip,
                QWidget& field);
    void addHeading(QGridLayout& grid, const QString& text);
    void change(const QString& text, const Change& change, bool isTyped = false);
    void chooseKind(int kind);
    void refresh();

    MarkerDesk& desk_;
    FieldGuard& guard_;
    QComboBox *material_, *kind_, *turns_;
    LengthEdit *width_ = nullptr, *along_ = nullptr, *across_ = nullptr;
    LengthEdit *gap_ = nullptr, *border_ = nullptr;
    LengthEdit *warp_ = nullptr, *weft_ = nullptr;
    AngleEdit* tolerance_;
    QCheckBox* folded_;
    QSpinBox* garments_;
    int gesture_ = -1;
};

}  // namespace toile::app
