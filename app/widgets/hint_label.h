// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFontMetrics>
#include <QLabel>
#include <vector>

namespace toile::app {

/// "Shift+drag: move" says what comes of a key or of a movement of the mouse; without a colon it is
/// a sentence.
struct HintClause {
    QString keys{}, what{};
};

/// Those of "Click: select · Drag: turn · Wheel: zoom".
std::vector<HintClause> hintClauses(const QString& text);

/// One line of a status bar, keys drawn as keys. The first few clauses, as far as whole ones fit;
/// the tool tip has them all.
class HintLabel : public QLabel {
    Q_OBJECT

public:
    /// A person reads no more of them at a glance.
    static constexpr std::size_t kMaxHintsShown = 3;

    explicit HintLabel(QWidget* parent = nullptr);

    /// Sets the text and its tool tip.
    void setHint(const QString& text);
    /// How many clauses fit into a width in pixels, the room for a mark that there are more
    /// included.
    std::size_t fitting(int width) const;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    int widthOf(const HintClause& clause) const;

    std::vector<HintClause> clauses_;
};

}  // namespace toile::app
