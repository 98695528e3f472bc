// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/lines_panel.h"

#include <QDate>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QScrollArea>
#include <QToolButton>
#include <utility>

#include "app/document/document.h"
#include "app/document/line_edits.h"
#include "app/panels/seam_ends_list.h"
#include "app/settings/length_display.h"
#include "app/text/figures.h"
#include "app/widgets/scrolled.h"
#include "core/pattern/line_fields.h"

namespace toile::app {

namespace {

/// Values shown for settings that are off.
LineSettings proposedLines() {
    LineSettings lines;
    lines.trueBelow = kProposedTrueing;
    return lines;
}

void setSpacing(QGridLayout& grid) {
    grid.setContentsMargins(10, 6, 10, 6);
    grid.setHorizontalSpacing(8);
    grid.setVerticalSpacing(4);
}

}  // namespace

LinesPanel::LinesPanel(Document& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      fields_(
          *this, [this] { return document_.newGesture(); },
          [this](const SettingChange& change) { take(change); }),
      straying_(makeNote("lineStraying", this)),
      ends_(new SeamEndsList(this)) {
    fields_.make(kLineFields, {}, proposedLines());
    auto* columns = new QHBoxLayout(this);
    columns->setContentsMargins(0, 0, 0, 0);
    columns->setSpacing(0);
    columns->addWidget(scrolledColumn(*makeSettings(), this), 1);
    columns->addWidget(scrolledColumn(*makeAdditions(), this), 1);
    columns->addWidget(ends_, 2);
    connect(ends_, &SeamEndsList::trueingWanted, this, [this](int end, bool trued) {
        const LineSettings lines = withSeamEnd(document_.state().lines, document_.garment()->seams,
                                               facts_.ends[static_cast<std::size_t>(end)], trued);
        document_.setLines(trued ? withFairing(lines) : lines,
                           trued ? tr("True seam end") : tr("Keep kink at seam end"));
    });
    connect(ends_, &SeamEndsList::seamChosen, &document_, &Document::setSeam);
    connect(&document_, &Document::opened, this, &LinesPanel::onOpened);
    connect(&document_, &Document::changed, this, &LinesPanel::onChanged);
    connect(&LengthDisplay::instance(), &LengthDisplay::changed, this, &LinesPanel::refresh);
    refresh();
}

QWidget& LinesPanel::firstField() const {
    return fields_.at("fairing");
}

QWidget* LinesPanel::makeSettings() {
    auto* settings = new QWidget(this);
    straying_->setWordWrap(true);
    auto* grid = new QGridLayout(settings);
    setSpacing(*grid);
    int row = 0;
    for (const char* path : {"fairing", "fairing.tolerance", "fairing.smoothing", "trueBelow"}) {
        fields_.addRow(*grid, path, row++);
    }
    grid->addWidget(straying_, row++, 0, 1, 3);
    grid->setColumnStretch(2, 1);
    grid->setRowStretch(row, 1);
    return settings;
}

QWidget* LinesPanel::makeAdditions() {
    auto* additions = new QWidget(this);
    auto* grid = new QGridLayout(additions);
    setSpacing(*grid);
    // To save height, a switch replaces the label of its group's first field.
    grid->addWidget(&fields_.at("allowance"), 0, 0);
    grid->addWidget(&fields_.at("allowance.seam"), 0, 1);
    fields_.addRow(*grid, "allowance.hem", 1);
    grid->addWidget(&fields_.at("notches"), 2, 0);
    grid->addWidget(&fields_.at("notches.form"), 2, 1);
    fields_.addRow(*grid, "notches.depth", 3);
    auto* label = new QGridLayout;
    label->setHorizontalSpacing(8);
    label->setVerticalSpacing(4);
    grid->addLayout(label, 4, 0, 1, 3);
    fields_.addRow(*label, "label.size", 0);
    fields_.addRow(*label, "label.date", 1);
    auto* today = makeButton("labelToday", tr("Today"), tr("Put today's date on the labels"), this);
    label->addWidget(today, 1, 2);
    for (int k = 1; k < static_cast<int>(kEdgeKindCount); ++k) {
        fields_.addRow(*grid, std::string("allowance.") + kEdgeWidthKeys[k], 4 + k);
    }
    grid->setColumnStretch(3, 1);
    grid->setRowStretch(4 + static_cast<int>(kEdgeKindCount), 1);
    connect(today, &QToolButton::clicked, this, [this] {
        auto& date = fields_.at<QLineEdit>("label.date");
        date.setText(QLocale().toString(QDate::currentDate(), QLocale::ShortFormat));
        emit date.editingFinished();
    });
    return additions;
}

void LinesPanel::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    if (isStale_) {
        refresh();
    }
}

void LinesPanel::onOpened() {
    notches_ = {};  // drop what belongs to another garment
    fields_.at<QLineEdit>("label.size").setModified(false);
    fields_.at<QLineEdit>("label.date").setModified(false);
}

void LinesPanel::onChanged(const DocumentChange& what) {
    if (what.touches(&Derived::garment, &Derived::results, &Derived::pattern, &DocumentState::lines,
                     &DocumentState::labels)) {
        refresh();
    } else if (what.touches(DocumentChange::Selection) && !isStale_) {
        ends_->select(document_.seam());
    }
}

void LinesPanel::refresh() {
    isStale_ = !isVisible();
    showSettings();
    if (isStale_ && document_.garment()) {
        return;
    }
    facts_ = document_.garment()
                 ? lineFacts(*document_.garment(), document_.results(), document_.state().lines)
                 : LineFacts{};
    if (document_.garment()) {
        ends_->show(document_, facts_);
        ends_->select(document_.seam());
    } else {
        ends_->clear();
    }
    showStraying();
}

void LinesPanel::showSettings() {
    const LineSettings& lines = document_.state().lines;
    fields_.setEnabled(document_.garment() != nullptr);
    LineSettings usual = proposedLines();
    AllowanceWidths& widths = usual.allowance.emplace(lines.allowance.value_or(AllowanceWidths{}));
    for (const auto& [kind, word] : kEdgeKindWords) {
        widths.edges[static_cast<std::size_t>(kind)] = widths.widthOf(kind);
    }
    fields_.show(kLineFields, lines, usual);
    notches_ = lines.notches.value_or(notches_);
}

void LinesPanel::showStraying() {
    if (!document_.garment() || !facts_.drawn) {
        straying_->setText(document_.garment() ? tr("All lines follow the exact outline.")
                                               : QString());
        return;
    }
    straying_->setText(
        tr("At most %1 from the exact outline. The largest strain changes from %2 to %3.")
            .arg(fineLength(facts_.farthest) + ' ' + lengthUnit(),
                 tr("%1 %").arg(percent(facts_.exactStrain)),
                 tr("%1 %").arg(percent(facts_.strain))));
}

void LinesPanel::take(const SettingChange& change) {
    const LineSettings& before = document_.state().lines;
    LineSettings lines = fields_.changed(kLineFields, before, change);
    if (change.path == "fairing.tolerance") {
        lines.fairing->isFixed = true;
    } else if (change.path == "trueBelow" && lines.trueBelow > 0) {
        lines = withFairing(std::move(lines));
    } else if (lines.notches && !before.notches) {
        lines.notches->automatic = notches_.automatic;
        lines.notches->notches = notches_.notches;
    }
    document_.setLines(std::move(lines), change.text, change.gesture);
    showSettings();
}

}  // namespace toile::app
