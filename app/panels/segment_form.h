// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <optional>

#include "app/document/line_facts.h"

class QCheckBox;
class QGridLayout;
class QLabel;
class QToolButton;

namespace toile::app {

class AllowanceRows;
class Document;
class FieldGuard;
class LengthEdit;
class SewnRows;
class StripRows;

/// The segment of an outline that is selected: how long it is, how it is drawn, what it meets at
/// its ends, and the turn point at a selected vertex. Says what is to be said of it.
class SegmentForm : public QWidget {
    Q_OBJECT

public:
    SegmentForm(Document& document, FieldGuard& guard, QWidget* parent = nullptr);

    /// Shows what is selected now.
    /// @param facts  of the document's garment as it is shown; stay until the next call
    void show(const LineFacts& facts);
    /// Shows that there is nothing.
    void clear();

signals:
    /// A decision about a segment. @param gesture  as for Document::edit
    void wanted(const toile::LineSettings& lines, const QString& text, int gesture);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void makeRows(FieldGuard& guard);
    void setFieldsEnabled(bool enabled);
    std::optional<SegmentAt> selected(const LineFacts& facts) const;
    void showLengths(const LineFacts& facts, const Segment& segment);
    void showKinks(const LineFacts& facts, const SegmentAt& at);
    void showTurnPoint(const LineFacts& facts);
    void setLength(std::optional<double> length);
    void setTolerance(std::optional<double> tolerance);
    void setStraight(bool straight);
    void setTurnPoint(bool turns);

    Document& document_;
    QLabel *title_, *lengths_, *kinks_;
    LengthEdit *length_, *tolerance_;
    QToolButton *asWorn_, *asOthers_, *addPoint_, *removePoint_;
    QCheckBox* straight_;
    AllowanceRows* allowance_;
    StripRows* strips_;
    SewnRows* sewn_;
    int gesture_ = -1;
    std::optional<SegmentAt> at_;
    Segment shown_{};                            ///< as it was last shown
    std::optional<LineStretch> partner_{};       ///< of the segment that it is sewn to
    std::optional<TurnPointSettings> vertex_{};  ///< the selected one, where it is on an outline
};

}  // namespace toile::app
