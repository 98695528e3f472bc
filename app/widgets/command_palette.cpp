// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/widgets/command_palette.h"

#include <QApplication>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPainter>
#include <QStyledItemDelegate>
#include <QTextLayout>
#include <QVBoxLayout>
#include <algorithm>

namespace toile::app {

namespace {

constexpr int kWidth = 640, kRowsShown = 12, kMargin = 8;
/// Longer lists are useless: typing another letter is quicker than scrolling.
constexpr std::size_t kMaxRows = 200;

constexpr int kPad = 10, kIcon = 18, kGap = 14, kAir = 12;

/// Paints the text with marked letters, as far as it fits.
/// @return its width
double paintText(QPainter& painter, const QRectF& place, const QFont& font, const QString& text,
                 const QList<QVariant>& letters) {
    QTextLayout layout(text, font);
    QList<QTextLayout::FormatRange> marks;
    for (const QVariant& letter : letters) {
        QTextLayout::FormatRange mark;
        mark.start = letter.toInt();
        mark.length = 1;
        mark.format.setFontWeight(QFont::Bold);
        marks << mark;
    }
    layout.setFormats(marks);
    layout.beginLayout();
    QTextLine line = layout.createLine();
    layout.endLayout();
    painter.save();
    painter.setClipRect(place);
    layout.draw(&painter, {place.left(), place.center().y() - line.height() / 2});
    painter.restore();
    return line.naturalTextWidth();
}

/// Paints a row: the text with matched letters in bold, its menu path in a faint colour, and its
/// keys at the right edge.
class CommandDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
};

void CommandDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                            const QModelIndex& index) const {
    const bool enabled = index.flags().testFlag(Qt::ItemIsEnabled);
    const bool selected = option.state.testFlag(QStyle::State_Selected);
    const auto group = enabled ? QPalette::Active : QPalette::Disabled;
    const QPalette& palette = option.palette;
    if (selected) {
        painter->fillRect(
            option.rect,
            palette.color(enabled ? QPalette::Active : QPalette::Disabled, QPalette::Highlight));
    }
    const QColor ink = palette.color(group, selected ? QPalette::HighlightedText : QPalette::Text);
    QColor faint = ink;
    faint.setAlphaF(enabled ? 0.66F : 0.9F);

    QRect row = option.rect.adjusted(kPad, 0, -kPad, 0);
    const auto icon = index.data(Qt::DecorationRole).value<QIcon>();
    const QRect iconPlace(row.left(), row.center().y() - kIcon / 2, kIcon, kIcon);
    if (!icon.isNull()) {
        icon.paint(painter, iconPlace, Qt::AlignCenter, enabled ? QIcon::Normal : QIcon::Disabled);
    }
    row.setLeft(iconPlace.right() + kPad);

    painter->setFont(option.font);
    const QString keys = index.data(CommandPalette::KeysRole).toString();
    if (!keys.isEmpty()) {
        painter->setPen(faint);
        painter->drawText(row, Qt::AlignRight | Qt::AlignVCenter, keys);
        row.setRight(row.right() - option.fontMetrics.horizontalAdvance(keys) - kGap);
    }
    painter->setPen(ink);
    const double width =
        paintText(*painter, row, option.font, index.data(Qt::DisplayRole).toString(),
                  index.data(CommandPalette::LettersRole).toList());
    row.setLeft(row.left() + qRound(width) + kGap);
    if (row.width() > 2 * kGap) {
        painter->setPen(faint);
        painter->drawText(
            row, Qt::AlignLeft | Qt::AlignVCenter,
            option.fontMetrics.elidedText(index.data(CommandPalette::PlaceRole).toString(),
                                          Qt::ElideRight, row.width()));
    }
}

QSize CommandDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const {
    return {200, option.fontMetrics.height() + kAir};
}

QListWidgetItem* makeRow(const Command& command, const std::vector<int>& letters) {
    auto* row = new QListWidgetItem(command.icon, command.text);
    row->setData(CommandPalette::PlaceRole, command.place);
    row->setData(CommandPalette::KeysRole, command.keys);
    QVariantList marks;
    for (const int letter : letters) {
        marks << letter;
    }
    row->setData(CommandPalette::LettersRole, marks);
    if (!command.enabled) {
        row->setFlags(Qt::ItemIsSelectable);
    }
    return row;
}

}  // namespace

CommandPalette::CommandPalette(QWidget* parent)
    : QFrame(parent),
      line_(new QLineEdit(this)),
      list_(new QListWidget(this)),
      tip_(new QLabel(this)) {
    setObjectName("commandPalette");
    setFrameShape(QFrame::StyledPanel);
    setFrameShadow(QFrame::Raised);
    setLineWidth(1);
    setAutoFillBackground(true);
    line_->setObjectName("commandLine");
    line_->setPlaceholderText(tr("Type a command, a piece or a seam"));
    line_->setAccessibleName(tr("Command"));
    line_->setClearButtonEnabled(true);
    line_->setMinimumHeight(34);
    line_->setTextMargins(6, 0, 6, 0);
    list_->setObjectName("commandList");
    list_->setAccessibleName(tr("Commands found"));
    list_->setItemDelegate(new CommandDelegate(list_));
    list_->setFocusPolicy(Qt::NoFocus);
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list_->setUniformItemSizes(true);
    list_->setFrameShape(QFrame::NoFrame);
    tip_->setObjectName("commandTip");
    tip_->setForegroundRole(QPalette::PlaceholderText);
    tip_->setContentsMargins(4, 0, 4, 0);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(kMargin, kMargin, kMargin, kMargin);
    layout->setSpacing(6);
    layout->addWidget(line_);
    layout->addWidget(list_);
    layout->addWidget(tip_);
    line_->installEventFilter(this);
    parent->installEventFilter(this);
    connect(line_, &QLineEdit::textChanged, this, &CommandPalette::updateList);
    connect(list_, &QListWidget::currentRowChanged, this, &CommandPalette::updateTip);
    connect(list_, &QListWidget::itemClicked, this, &CommandPalette::runCurrent);
    hide();
}

void CommandPalette::open(std::vector<Command> commands) {
    commands_ = std::move(commands);
    if (!isVisible()) {
        focusBefore_ = QApplication::focusWidget();
    }
    line_->clear();
    updateList();
    show();
    raise();
    line_->setFocus(Qt::PopupFocusReason);
}

void CommandPalette::updateList() {
    found_ = searchCommands(commands_, line_->text());
    found_.resize(std::min(found_.size(), kMaxRows));
    list_->clear();
    for (const FoundCommand& found : found_) {
        list_->addItem(makeRow(commands_[static_cast<std::size_t>(found.command)], found.letters));
    }
    list_->setVisible(!found_.empty());
    list_->setCurrentRow(found_.empty() ? -1 : 0);
    updateTip();
    updatePlace();
}

void CommandPalette::updateTip() {
    const int row = list_->currentRow();
    if (row < 0 || row >= static_cast<int>(found_.size())) {
        tip_->setText(tr("No matches"));
        return;
    }
    const auto at = static_cast<std::size_t>(found_[static_cast<std::size_t>(row)].command);
    const Command& command = commands_[at];
    const QString tip =
        command.enabled ? command.tip : tr("Not available now: %1").arg(command.tip);
    tip_->setText(tip_->fontMetrics().elidedText(tip, Qt::ElideRight, kWidth - 4 * kMargin));
}

void CommandPalette::updatePlace() {
    const QWidget& window = *parentWidget();
    const int rowHeight = list_->count() > 0 ? list_->sizeHintForRow(0) : 0;
    list_->setFixedHeight(std::min(list_->count(), kRowsShown) * rowHeight);
    const int width = std::min(kWidth, window.width() - 4 * kMargin);
    setFixedWidth(std::max(width, 0));
    layout()->activate();
    adjustSize();
    move((window.width() - this->width()) / 2, std::max(kMargin, window.height() / 9));
}

bool CommandPalette::eventFilter(QObject* watched, QEvent* event) {
    if (watched == parentWidget()) {
        if (event->type() == QEvent::Resize && isVisible()) {
            updatePlace();
        }
        return false;
    }
    switch (event->type()) {
        case QEvent::ShortcutOverride: {
            // Accepting ShortcutOverride keeps these keys from the window's shortcuts.
            const int key = static_cast<QKeyEvent*>(event)->key();
            if (key == Qt::Key_Escape || key == Qt::Key_Return || key == Qt::Key_Enter) {
                event->accept();
                return true;
            }
            return false;
        }
        case QEvent::KeyPress:
            return pressKey(static_cast<QKeyEvent*>(event)->key());
        case QEvent::FocusOut:
            if (static_cast<QFocusEvent*>(event)->reason() != Qt::ActiveWindowFocusReason &&
                static_cast<QFocusEvent*>(event)->reason() != Qt::PopupFocusReason) {
                hide();
            }
            return false;
        default:
            return false;
    }
}

bool CommandPalette::pressKey(int key) {
    switch (key) {
        case Qt::Key_Escape:
            closeAndGiveBack();
            return true;
        case Qt::Key_Return:
        case Qt::Key_Enter:
            runCurrent();
            return true;
        case Qt::Key_Up:
            moveBy(-1);
            return true;
        case Qt::Key_Down:
            moveBy(1);
            return true;
        case Qt::Key_PageUp:
            moveBy(-kRowsShown);
            return true;
        case Qt::Key_PageDown:
            moveBy(kRowsShown);
            return true;
        default:
            return false;
    }
}

void CommandPalette::moveBy(int rows) {
    const int count = list_->count();
    if (count == 0) {
        return;
    }
    const int row = list_->currentRow() + rows;
    // Single steps wrap around; page steps stop at the ends.
    list_->setCurrentRow(std::abs(rows) == 1 ? (row + count) % count
                                             : std::clamp(row, 0, count - 1));
}

void CommandPalette::runCurrent() {
    const int row = list_->currentRow();
    if (row < 0) {
        return;
    }
    const auto at = static_cast<std::size_t>(found_[static_cast<std::size_t>(row)].command);
    if (!commands_[at].enabled) {
        return;
    }
    const std::function<void()> run = commands_[at].run;
    closeAndGiveBack();  // first, because the command may take the focus
    run();
}

void CommandPalette::closeAndGiveBack() {
    hide();
    if (focusBefore_) {
        focusBefore_->setFocus(Qt::PopupFocusReason);
    }
}

}  // namespace toile::app
