// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <optional>

#include "app/document/line_facts.h"
#include "app/widgets/setting_fields.h"

class QCheckBox;

namespace toile::app {

class Document;

/// The selected segment of an outline: its length, its line, the allowance, extension and facing
/// along it, the seam that it belongs to, and the turn point at a selected vertex. Edits are
/// mirrored where the document mirrors them.
class SegmentForm : public QWidget {
    Q_OBJECT

public:
    explicit SegmentForm(Document& document, QWidget* parent = nullptr);

    /// Shows the selection.
    /// @param facts  of the document's garment as it is shown; must exist until the next call
    void show(const LineFacts& facts);
    /// Shows no segment.
    void clear();

private:
    void makeLayout();
    std::optional<SegmentAt> selected(const LineFacts& facts) const;
    void showLengths();
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
    Segment shown_{};                            ///< with the length that its partner has
    std::optional<LineStretch> partner_{};       ///< of the segment that it is sewn to
    int seam_ = -1;                              ///< to which it belongs; -1: it is not sewn
    std::optional<TurnPointSettings> vertex_{};  ///< at the selected vertex of an outline
};

}  // namespace toile::app
