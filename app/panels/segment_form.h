// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <optional>

#include "app/document/line_facts.h"
#include "app/widgets/setting_fields.h"

class QCheckBox;

namespace toile {
struct PatternSegment;
}

namespace toile::app {

class Document;

/// The selected segment of an outline: its length, line, allowance, extension, facing and seam, and
/// the turn point at a selected vertex. Edits also apply to the mirror image if the document
/// mirrors edits.
class SegmentForm : public QWidget {
    Q_OBJECT

public:
    explicit SegmentForm(Document& document, QWidget* parent = nullptr);

    /// Shows the selection.
    /// @param facts  of the document's current garment; must exist until the next call
    void show(const LineFacts& facts);
    /// Shows no segment.
    void clear();

private:
    void makeLayout();
    std::optional<SegmentAt> selected(const LineFacts& facts) const;
    void showLengths();
    const PatternSegment* drawn() const;
    double usualAllowance() const;
    void showBeside();
    void showKinks(const LineFacts& facts, const SegmentAt& at);
    void showTurnPoint(const LineFacts& facts);
    void take(const SettingChange& change);
    LineSettings withSettings(const std::string& changed, SegmentSettings settings) const;
    LineSettings withFacing(std::optional<double> width) const;
    std::vector<SegmentAt> alike(bool bothSides) const;
    void addNotch();
    void removeNotch();
    void setTurnPoint(bool turns);

    Document& document_;
    SettingFields fields_;
    QLabel *title_, *lengths_, *kinks_, *notches_;
    QToolButton *addPoint_, *removePoint_, *addNotch_, *removeNotch_;
    QCheckBox* bothSides_;
    QString cornerHelp_{};
    const LineFacts* facts_ = nullptr;  ///< null if no segment is shown
    std::optional<SegmentAt> at_{};
    Segment shown_{};                            ///< may have its partner's length
    std::optional<LineStretch> partner_{};       ///< the segment that it is sewn to
    int seam_ = -1;                              ///< its seam; -1: it is not sewn
    std::optional<TurnPointSettings> vertex_{};  ///< at the selected vertex of an outline
};

}  // namespace toile::app
