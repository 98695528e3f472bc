// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFontMetrics>
#include <QLabel>
#include <vector>

namespace toile::app {

/// "Shift+drag: move" describes a key or a mouse gesture. Without a colon it is a sentence.
struct HintClause {
    QString keys{}, what{};
};

/// Splits a text such as "Click: select · Drag: turn · Wheel: zoom".
std::vector<HintClause> hintClauses(const QString& text);

/// One line of a status bar, with keys drawn as keys. Shows the first clauses that fit as a whole;
/// the tool tip has all of them.
class HintLabel : public QLabel {
    Q_OBJECT

public:
    /// More cannot be read at a glance.
    static constexpr std::size_t kMaxHintsShown = 3;

    explicit HintLabel(QWidget* parent = nullptr);

    /// Sets the text and its tool tip.
    void setHint(const QString& text);
    /// Number of clauses that fit into a width in pixels, including the mark for further ones.
    std::size_t fitting(int width) const;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    int widthOf(const HintClause& clause) const;

    std::vector<HintClause> clauses_;
};

}  // namespace toile::app
