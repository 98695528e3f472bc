// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <optional>

#include "app/document/line_facts.h"

class QCheckBox;
class QComboBox;
class QGridLayout;
class QLabel;
class QToolButton;
class QWidget;

namespace toile::app {

class Document;
class FieldGuard;
class LengthEdit;
class PercentEdit;

/// Rows of the segment form about strips along it: the extension of a free edge and the width of
/// its facing; 0: none. Emits `wanted` with the new settings, which include its mirror image.
class StripRows : public QObject {
    Q_OBJECT

public:
    StripRows(Document& document, FieldGuard& guard, QWidget* form);

    /// @return the next free row
    int addTo(QGridLayout& grid, int row);
    /// @param facts  of the document's garment as it is shown; stay until the next call
    void show(const LineFacts& facts, const SegmentAt& at);
    /// Shows that there is nothing.
    void clear();

signals:
    /// A decision about a segment. @param gesture  as for Document::edit
    void wanted(const toile::LineSettings& lines, const QString& text, int gesture);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    std::vector<SegmentAt> segments() const;
    void setExtension(std::optional<double> width);
    void setFacing(std::optional<double> width);
    void say(const LineSettings& lines, const QString& text);

    Document& document_;
    LengthEdit *extension_, *facing_;
    const LineFacts* facts_ = nullptr;  ///< null where no segment is shown
    SegmentAt at_{};
    int gesture_ = -1;
};

/// Rows of the segment form about the seam that it belongs to: its ease and its notches.
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

/// Rows of the segment form about the seam allowance: its width on one side of the seam or on both,
/// and the corner with the segment before. Emits `wanted` with the new settings.
class AllowanceRows : public QObject {
    Q_OBJECT

public:
    AllowanceRows(Document& document, FieldGuard& guard, QWidget* form);

    /// @return the next free row
    int addTo(QGridLayout& grid, int row);
    /// @param facts   of the document's garment as it is shown; stay until the next call
    /// @param before  what the segment is called that ends where this one begins
    void show(const LineFacts& facts, const SegmentAt& at, const QString& before);
    /// Shows that there is nothing.
    void clear();

signals:
    /// A decision about a segment. @param gesture  as for Document::edit
    void wanted(const toile::LineSettings& lines, const QString& text, int gesture);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void setWidth(std::optional<double> width);
    void setCorner(int row);
    void setEnabled(bool enabled);

    Document& document_;
    LengthEdit* width_;
    QToolButton* asKind_;
    QCheckBox* bothSides_;
    QComboBox* corner_;
    const LineFacts* facts_ = nullptr;  ///< null where no segment is shown
    SegmentAt at_{};
    int gesture_ = -1;
};

}  // namespace toile::app
