// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/compare/compare_window.h"

#include <QAction>
#include <QClipboard>
#include <QComboBox>
#include <QGuiApplication>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPainter>
#include <QPushButton>
#include <QScreen>
#include <QShowEvent>
#include <QStackedWidget>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <iterator>

#include "app/base/text.h"
#include "app/document/document.h"
#include "app/render/gl_support.h"
#include "app/render/overlay_values.h"
#include "app/render/pattern_renderer.h"
#include "app/settings/length_display.h"
#include "app/text/error_text.h"
#include "app/text/figures.h"
#include "app/views/colour_bar.h"
#include "app/views/view_text.h"

namespace toile::app {
namespace {

/// Rows of the table.
constexpr int kMethodChoices = 0, kPictures = 1, kUseButtons = 2, kFirstFigure = 3;
/// Space at the bottom for the scale bar, logical pixels.
constexpr Camera2D::Margins kMargins{14, 14, 50};
/// Defaults besides the document's own method; the last is dropped if that is one of them.
constexpr Method kFirst[] = {Method::Curvature, Method::Wang2005, Method::Lscm, Method::Isometric};
constexpr double kMillisecond = 1e-3;
constexpr QChar kDash(0x2013), kStar(0x2605);

/// The rows, most important first.
constexpr Criterion kRows[] = {
    Criterion::StrainMean,   Criterion::StrainMax,        Criterion::StrainMin,
    Criterion::SeamMismatch, Criterion::LengthError,      Criterion::PiA,
    Criterion::ReferenceRms, Criterion::FlippedTriangles, Criterion::OutlineCrossings,
    Criterion::Seconds,
};

/// Formats a value without unit.
QString figureText(FigureFormat format, double value) {
    switch (format) {
        case FigureFormat::Seconds:
            value /= kMillisecond;
            return QLocale().toString(value, 'f', value < 100 ? 1 : 0);
        case FigureFormat::Ratio:
            return percent(value);
        case FigureFormat::SignedRatio:
            return signedPercent(value);
        case FigureFormat::LengthError:
            return boundaryError(value);
        case FigureFormat::Count:
            return QLocale().toString(static_cast<int>(value));
        case FigureFormat::Millimetres:
            return fineLength(value);
    }
    return {};
}

/// Marks the best method, and those with the same displayed text; none if all are the same.
std::vector<bool> bestOnes(Criterion criterion, const std::vector<std::optional<double>>& values,
                           const QStringList& texts) {
    const auto best = bestOf(criterion, values);
    const QString text = best ? texts[static_cast<qsizetype>(*best)] : QString();
    const auto isOther = [&](const QString& other) { return !other.isEmpty() && other != text; };
    const bool isAny = best && std::ranges::any_of(texts, isOther);
    std::vector<bool> marks;
    for (const QString& each : texts) {
        marks.push_back(isAny && each == text);
    }
    return marks;
}

/// The union of both ranges.
OverlayScale united(const OverlayScale& one, const OverlayScale& other) {
    OverlayScale both = one;
    both.low = std::min(one.low, other.low);
    both.high = std::max(one.high, other.high);
    both.below = (one.below && one.low == both.low) || (other.below && other.low == both.low);
    both.above = (one.above && one.high == both.high) || (other.above && other.high == both.high);
    return both;
}

/// Bounding box of the outline: tighter than a transformed box if the piece is rotated.
Eigen::AlignedBox2d outlineBox(const Scene& scene, const Placement& placement) {
    Eigen::AlignedBox2d box;
    const VertexRun run = scene.patternLines.outlines.front();
    for (std::uint32_t i = run.first; i < run.first + run.count; ++i) {
        box.extend(placement.applied(flatPoint(scene.lineVertices[i])));
    }
    return box;
}

}  // namespace

ComparedPicture::ComparedPicture(SheetCamera& camera, bool hasScaleBar, QWidget* parent)
    : RenderedWidget(std::make_unique<PatternRenderer>(), parent),
      camera_(camera),
      canvas_(*this, camera, true),
      hasScaleBar_(hasScaleBar) {
    setMinimumSize(120, 120);
    setCursor(Qt::OpenHandCursor);
    connect(&camera_, &SheetCamera::moved, this, [this] { update(); });
}

void ComparedPicture::setContent(SceneContent content, const ViewState& view) {
    view_ = view;
    renderer().show(std::move(content));
    update();
}

void ComparedPicture::paintGL() {
    const RenderStyle style = renderStyle(palette());
    const Camera2D camera = camera_.seenIn(size());
    if (problem().isEmpty()) {
        const QSize onDevice = devicePixels(*this);
        static_cast<PatternRenderer&>(renderer())
            .paint(camera, view_, style, onDevice.width(), onDevice.height(), devicePixelRatioF());
    }
    OverPainter over(*this);
    QPainter& painter = over.painter();
    if (!problem().isEmpty()) {
        paintProblem(painter, style, rect(), problem());
    } else if (hasScaleBar_) {
        paintScaleBar(painter, style, rect(), camera.pixelsPerMillimetre());
    }
    if (hasFocus()) {
        painter.setPen(QPen(palette().color(QPalette::Highlight), 2));
        painter.drawRect(QRectF(rect()).adjusted(1, 1, -1, -1));
    }
}

void ComparedPicture::resizeEvent(QResizeEvent* event) {
    RenderedWidget::resizeEvent(event);
    camera_.setViewport(size());
}

CompareWindow::CompareWindow(Document& document, const JobRunner& ordinary, QWidget* parent)
    : QDialog(parent),
      document_(document),
      camera_(kMargins),
      comparison_(document, ordinary),
      table_(new QTableWidget(kFirstFigure, kMethods, this)),
      legend_(new ColourBar(this)) {
    setObjectName("compareWindow");
    setWindowTitle(tr("Compare methods"));
    setSizeGripEnabled(true);
    const QString problem = glProblem();
    legend_->setObjectName("compareLegend");
    legend_->setVisible(problem.isEmpty());
    auto* note = new QLabel(problem.isEmpty()
                                ? tr("★ best of its row. Seam Δ: the worst seam of the piece; its "
                                     "neighbours are flattened by the same method. Drag: move all "
                                     "pictures · Wheel: zoom · Double click: show everything")
                                : tr("Pictures are not available: %1").arg(problem),
                            this);
    note->setObjectName("compareNote");
    note->setWordWrap(true);
    makeTable();
    for (int i = 0; i < kMethods; ++i) {
        makeColumn(i, problem.isEmpty());
    }
    auto* column = new QVBoxLayout(this);
    column->addWidget(table_, 1);
    column->addWidget(legend_);
    column->addWidget(note);
    connect(&comparison_, &MethodComparison::changed, this, &CompareWindow::refresh);
    connect(&document_, &Document::changed, this, [this] {
        if (isVisible()) {
            showPictures();
        }
    });
    connect(&LengthDisplay::instance(), &LengthDisplay::changed, this, &CompareWindow::refresh);
    resize(QSize(1360, 860).boundedTo(screen()->availableSize() * 0.95));
}

CompareWindow::~CompareWindow() {
    comparison_.disconnect();
}

void CompareWindow::makeTable() {
    table_->setObjectName("compareTable");
    table_->setAccessibleName(tr("Figures of the methods"));
    table_->setShowGrid(false);
    table_->setTabKeyNavigation(false);
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->horizontalHeader()->hide();
    table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    QHeaderView& rows = *table_->verticalHeader();
    rows.setSectionResizeMode(QHeaderView::ResizeToContents);
    rows.setSectionResizeMode(kPictures, QHeaderView::Stretch);
    rows.setSectionsClickable(false);
    rows.setHighlightSections(false);
    auto* copy = new QAction(tr("&Copy"), table_);
    copy->setObjectName("copyComparison");
    copy->setShortcut(QKeySequence::Copy);
    copy->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    connect(copy, &QAction::triggered, this,
            [this] { QGuiApplication::clipboard()->setText(copiedFigures()); });
    table_->addAction(copy);
    table_->setContextMenuPolicy(Qt::ActionsContextMenu);
}

void CompareWindow::makeColumn(int number, bool canDraw) {
    Column& column = columns_[static_cast<std::size_t>(number)];
    const auto name = [number](const char* part) {
        return QString("compare%1%2").arg(part).arg(number);
    };
    column.method = new QComboBox;
    column.method->setObjectName(name("Method"));
    column.method->setAccessibleName(tr("Method"));
    for (const MethodTraits& known : allMethods()) {
        column.method->addItem(methodName(known.method), static_cast<int>(known.method));
    }
    connect(column.method, &QComboBox::activated, this, [this] {
        isChosen_ = true;
        chooseMethods();
    });
    column.message = new QLabel;
    column.message->setObjectName(name("Message"));
    column.message->setAlignment(Qt::AlignCenter);
    column.message->setWordWrap(true);
    column.message->setTextInteractionFlags(Qt::TextSelectableByMouse);
    column.pages = new QStackedWidget;
    column.pages->addWidget(column.message);
    if (canDraw) {
        column.picture = new ComparedPicture(camera_, number == 0, column.pages);
        column.picture->setObjectName(name("Picture"));
        column.pages->addWidget(column.picture);
    }
    column.use = new QPushButton(tr("Use this method"));
    column.use->setObjectName(name("Use"));
    column.use->setAutoDefault(false);
    column.use->setToolTip(tr("Flatten the garment by this method"));
    connect(column.use, &QPushButton::clicked, this,
            [this, &column] { emit methodWanted(Method(column.method->currentData().toInt())); });
    table_->setCellWidget(kMethodChoices, number, column.method);
    table_->setCellWidget(kPictures, number, column.pages);
    table_->setCellWidget(kUseButtons, number, column.use);
}

void CompareWindow::showEvent(QShowEvent* event) {
    QDialog::showEvent(event);
    if (event->spontaneous()) {
        return;
    }
    std::vector<Method> methods{document_.options().method};
    std::ranges::remove_copy(kFirst, std::back_inserter(methods), methods.front());
    for (std::size_t i = 0; i < kMethods && !isChosen_; ++i) {
        QComboBox& box = *columns_[i].method;
        box.setCurrentIndex(box.findData(static_cast<int>(methods[i])));
    }
    chooseMethods();
    camera_.frameAll();
    comparison_.begin();
}

void CompareWindow::hideEvent(QHideEvent* event) {
    QDialog::hideEvent(event);
    if (!event->spontaneous()) {
        comparison_.end();
    }
}

void CompareWindow::chooseMethods() {
    std::vector<Method> methods;
    for (const Column& column : columns_) {
        methods.push_back(Method(column.method->currentData().toInt()));
    }
    comparison_.setMethods(std::move(methods));
}

void CompareWindow::refresh() {
    const auto& entries = comparison_.entries();
    const int piece = comparison_.piece();
    const bool isShown = !entries.empty() && piece < document_.pieceCount();
    std::vector<Criterion> rows(std::begin(kRows), isShown ? std::end(kRows) : std::begin(kRows));
    if (std::ranges::none_of(entries, [](const auto& entry) -> bool {
            return entry.made.figures[Criterion::ReferenceRms].has_value();
        })) {
        std::erase(rows, Criterion::ReferenceRms);
    }
    // Do not clear the table first, or screen readers would lose their place in it.
    table_->setRowCount(kFirstFigure + static_cast<int>(rows.size()));
    table_->setVerticalHeaderLabels({isShown ? pieceName(document_, piece) : QString(), {}, {}});
    for (int row = kFirstFigure; row < table_->rowCount(); ++row) {
        showFigure(row, traits(rows[static_cast<std::size_t>(row - kFirstFigure)]));
    }
    if (std::exchange(shownPiece_, piece) != piece) {
        camera_.frameAll();
    }
    showPictures();
}

void CompareWindow::showFigure(int row, const CriterionTraits& criterion) {
    const QString tip = app::tr(criterion.tip);
    auto* title = new QTableWidgetItem(app::tr(criterion.title).replace("%1", lengthUnit()));
    title->setToolTip(tip);
    title->setTextAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    table_->setVerticalHeaderItem(row, title);
    std::vector<std::optional<double>> values;
    QStringList texts;
    for (const MethodComparison::Entry& entry : comparison_.entries()) {
        const auto& value = values.emplace_back(entry.made.figures[criterion.criterion]);
        texts << (value ? figureText(criterion.format, *value)
                  : entry.stage == MethodComparison::Stage::Done ? QString(kDash)
                                                                 : QString());
    }
    const std::vector<bool> best = bestOnes(criterion.criterion, values, texts);
    for (int column = 0; column < kMethods; ++column) {
        const QString& text = texts[column];
        const bool isBest = best[static_cast<std::size_t>(column)];
        auto* cell = new QTableWidgetItem(isBest ? QString("%1 %2").arg(kStar).arg(text) : text);
        cell->setData(PlainRole, text);
        cell->setData(Qt::AccessibleTextRole, isBest ? tr("%1, the best").arg(text) : text);
        cell->setToolTip(tip);
        cell->setTextAlignment(Qt::AlignCenter);
        if (isBest) {
            QFont bold;
            bold.setBold(true);
            cell->setFont(bold);
        }
        table_->setItem(row, column, cell);
    }
}

/// Titles and selected rows (all rows without a selection), with cells separated by tabs.
QString CompareWindow::copiedFigures() const {
    const QItemSelectionModel& selection = *table_->selectionModel();
    QStringList lines, cells{QString()};
    for (const auto& entry : comparison_.entries()) {
        cells << methodName(entry.method);
    }
    lines << cells.join('\t');
    for (int row = kFirstFigure; row < table_->rowCount(); ++row) {
        if (selection.hasSelection() && !selection.isRowSelected(row, {})) {
            continue;
        }
        cells = {table_->verticalHeaderItem(row)->text()};
        for (int column = 0; column < kMethods; ++column) {
            cells << table_->item(row, column)->data(PlainRole).toString();
        }
        lines << cells.join('\t');
    }
    return lines.join('\n') + '\n';
}

void CompareWindow::showPictures() {
    const auto& entries = comparison_.entries();
    const int piece = comparison_.piece();
    ViewState view = document_.view();
    if (!isMeasured(view.overlay)) {
        view.overlay = Overlay::Strain;  // the flat checkerboard looks the same for any method
    }
    view.seams = false;
    SceneContent content;
    content.fabric = piece >= 0 && piece < document_.pieceCount() ? document_.fabricOf(piece)
                                                                  : document_.fabric();
    for (const auto& entry : entries) {
        if (entry.made.scene) {
            const auto own = overlayScale(*entry.made.scene, view.overlay, content.fabric);
            content.scale = content.scale ? united(*content.scale, own) : own;
        }
    }
    if (!content.scale) {
        content.scale = overlayScale(Scene{}, view.overlay, content.fabric);
    }
    Eigen::AlignedBox2d box;
    for (std::size_t i = 0; i < kMethods; ++i) {
        if (i < entries.size()) {
            box.extend(showPicture(columns_[i], entries[i], content, view));
        } else {
            columns_[i].message->clear();
            columns_[i].pages->setCurrentWidget(columns_[i].message);
        }
    }
    camera_.setBox(box);
    legend_->show({.overlay = view.overlay, .scale = *content.scale});
}

Eigen::AlignedBox2d CompareWindow::showPicture(Column& column, const MethodComparison::Entry& entry,
                                               SceneContent content, const ViewState& view) {
    using Stage = MethodComparison::Stage;
    const QString name = methodName(entry.method);
    const bool inUse = entry.method == document_.options().method;
    column.use->setEnabled(!inUse);
    column.use->setText(inUse ? tr("In use") : tr("Use this method"));
    column.use->setAccessibleName(QString("%1: %2").arg(column.use->text(), name));
    const auto& error = entry.stage == Stage::Done ? entry.made.result->error : std::nullopt;
    column.message->setText(entry.stage == Stage::Waiting   ? tr("Waiting…")
                            : entry.stage == Stage::Working ? tr("Flattening…")
                            : entry.stage == Stage::Failed  ? entry.problem
                            : error                         ? errorText(*error)
                                                            : QString());
    if (!column.picture || !entry.made.scene) {
        column.pages->setCurrentWidget(column.message);
        return {};
    }
    column.pages->setCurrentWidget(column.picture);
    column.picture->setAccessibleName(tr("%1, the flat piece").arg(name));
    content.scene = entry.made.scene;
    content.places = {placeOver(column, entry.made.result)};
    const auto box = outlineBox(*content.scene, content.places.front().placement);
    column.picture->setContent(std::move(content), view);
    return box;
}

/// Aligns a result with the reference as well as possible, since flat coordinates differ between
/// methods.
SheetPlace CompareWindow::placeOver(Column& column,
                                    const std::shared_ptr<const PieceResult>& result) const {
    const auto piece = static_cast<std::size_t>(comparison_.piece());
    const auto& entries = comparison_.entries();
    // The placement settings refer to the document's own result; without that, use any result.
    auto over = piece < document_.results().size() ? document_.results()[piece]
                                                   : entries.front().made.result;
    for (const auto& entry : entries) {
        over = over && over->flat ? over : entry.made.result;
    }
    if (result != column.result || over != column.reference) {
        column.result = result;
        column.reference = over;
        column.motion = flatMotions({over}, {result}).front();
    }
    PieceSettings settings =
        piece < document_.settings().size() ? document_.settings()[piece] : PieceSettings{};
    settings.anchors.clear();
    settings.placement = settings.placement.value_or(Placement{});
    if (column.motion) {
        settings =
            movedSettings(std::move(settings), column.motion->oldOfNew, column.motion->radius);
    }
    return placesOf({settings}).front();
}

}  // namespace toile::app
