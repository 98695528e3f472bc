// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/fabric_panel.h"

#include <QComboBox>
#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QLocale>
#include <QScrollArea>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <iterator>
#include <tuple>
#include <utility>

#include "app/document/document.h"
#include "app/settings/length_display.h"
#include "app/text/error_text.h"
#include "app/text/fabric_name.h"
#include "app/text/figures.h"
#include "app/widgets/scrolled.h"
#include "app/widgets/setting_fields.h"
#include "core/layout/arrange.h"
#include "core/project/place_pieces.h"

namespace toile::app {

namespace {

constexpr double kPercentPerShare = 100;
constexpr const char* kCustom = "custom";
constexpr int kPanelAir = 10;
/// The fit of fewer triangles takes 1 to 2 ms, so it is computed at once.
constexpr std::size_t kSmall = 10000;

constexpr Overlay kDirections[] = {Overlay::Warp, Overlay::Weft, Overlay::Bias};
constexpr const char* kLinks[] = {"warp", "weft", "bias"};
constexpr const char* kPieceLink = "piece";

constexpr auto kLimitFields = [](auto& at, auto& fabric) {
    const auto limits = [&at](auto& of, const char* least, const char* leastName, const char* most,
                              const char* mostName) {
        at.field(Setting{least,
                         "",
                         leastName,
                         TR("How far the cloth can shrink without folds; 0 or less"),
                         nullptr,
                         {},
                         Quantity::Percent},
                 of.least, -0.5, 0);
        at.field(Setting{most,
                         "",
                         mostName,
                         TR("How far the cloth can be stretched; 0 or more"),
                         nullptr,
                         {},
                         Quantity::Percent},
                 of.most, 0, 2);
    };
    limits(fabric.warp, "warpLeast", TR("Warp, shrinks"), "warpMost", TR("Warp, stretches"));
    limits(fabric.weft, "weftLeast", TR("Weft, shrinks"), "weftMost", TR("Weft, stretches"));
    limits(fabric.bias, "biasLeast", TR("Bias, shrinks"), "biasMost", TR("Bias, stretches"));
    at.field(Setting{"width", TR("&Width"), TR("Width of the cloth"),
                     TR("Usable width from selvedge to selvedge")},
             fabric.width, 1, kMaxClothWidth);
};

bool isSmall(const FabricQuestion& question) {
    return !question.scene || question.scene->faces.size() < kSmall;
}

/// Row of a preset; other fabrics have the row after the last preset.
int rowOf(const Fabric& fabric) {
    const auto presets = fabricPresets();
    const Fabric* preset = presetOf(fabric);
    return static_cast<int>(preset ? preset - presets.data() : std::ssize(presets));
}

QString capitalised(QString word) {
    return word.isEmpty() ? word : word.replace(0, 1, word.at(0).toUpper());
}

/// "0 %", "< 0.1 %", "12.3 %".
QString shareText(double share) {
    const QLocale locale;
    if (share > 0 && share < 0.001) {
        return FabricPanel::tr("< %1 %").arg(locale.toString(0.1, 'f', 1));
    }
    return FabricPanel::tr("%1 %").arg(share > 0 ? locale.toString(kPercentPerShare * share, 'f', 1)
                                                 : QString("0"));
}

QString linked(const QString& text, const QString& link) {
    return QString("<a href=\"%1\">%2</a>").arg(link, text.toHtmlEscaped());
}

/// Widgets in the rows from `first` up to, but not including, `end`.
std::vector<QWidget*> widgetsOfRows(const QGridLayout& grid, int first, int end) {
    std::vector<QWidget*> widgets;
    for (int index = 0; index < grid.count(); ++index) {
        int row = 0, column = 0, rows = 0, columns = 0;
        grid.getItemPosition(index, &row, &column, &rows, &columns);
        if (row >= first && row < end) {
            widgets.push_back(grid.itemAt(index)->widget());
        }
    }
    return widgets;
}

QLabel* makeWrappedNote(const QString& text, const char* objectName, QWidget* parent) {
    QLabel* note = makeNote(objectName, parent);
    note->setText(text);
    note->setWordWrap(true);
    return note;
}

void setShown(const std::vector<QWidget*>& widgets, bool shown) {
    for (QWidget* widget : widgets) {
        widget->setVisible(shown);
    }
}

}  // namespace

FabricPanel::FabricPanel(Document& document, QWidget* parent, const FitWork& work)
    : QWidget(parent),
      document_(document),
      fields_(
          *this, [this] { return document_.newGesture(); },
          [this](const SettingChange& change) { take(change); }),
      pages_(new QStackedWidget(this)),
      materialTitle_(new QLabel(tr("Fabric &of"), this)),
      material_(new QComboBox(this)),
      preset_(new QComboBox(this)),
      all_(new QLabel(this)),
      worst_(new QLabel(this)),
      follower_(
          work,
          [this](const auto& made, const FabricQuestion& question, bool) {
              // Show the fit of an earlier fabric or grain too, so that the figures change during
              // a long drag.
              if (clothOf(question.scene) == clothOf(document_.scene())) {
                  made.answer ? setFit(*made.answer) : setFit(std::nullopt, faultText(made.fault));
              }
          },
          isSmall) {
    fields_.make<Fabric>(kLimitFields, "fabric");
    auto* empty = makeWrappedNote(tr("Open a garment to set its fabric."), "fabricEmpty", this);
    empty->setAlignment(Qt::AlignCenter);
    empty->setContentsMargins(kPanelAir, kPanelAir, kPanelAir, kPanelAir);
    pages_->addWidget(scrolledColumn(*makeContents(), pages_));
    pages_->addWidget(empty);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(pages_);
    connect(&document_, &Document::changed, this, &FabricPanel::onChanged);
    connect(&LengthDisplay::instance(), &LengthDisplay::changed, this, &FabricPanel::showNeed);
    refresh();
    askForFit();
}

QWidget& FabricPanel::firstField() const {
    return *preset_;
}

QWidget* FabricPanel::makeContents() {
    auto* contents = new QWidget(this);
    auto* grid = new QGridLayout(contents);
    grid->setContentsMargins(kPanelAir, 6, kPanelAir, 6);
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(5);
    grid->setColumnStretch(1, 1);
    grid->setColumnStretch(2, 1);
    fields_.dress(*material_, "fabricMaterial", tr("Fabric of"),
                  tr("The garment, or a material that you set for pieces."));
    connect(material_, &QComboBox::activated, this, [this](int index) {
        shown_ = material_->itemData(index).toString().toStdString();
        refresh();
    });
    materialTitle_->setBuddy(material_);
    grid->addWidget(materialTitle_, 0, 0);
    grid->addWidget(material_, 0, 1, 1, 2);
    fields_.dress(*preset_, "fabricPreset", tr("Fabric"), tr("The fabric of the garment."));
    for (const Fabric& preset : fabricPresets()) {
        preset_->addItem(capitalised(fabricName(preset)));
    }
    preset_->addItem(capitalised(fabricName({kCustom, {}, {}, {}})));
    connect(preset_, &QComboBox::activated, this, &FabricPanel::choosePreset);
    auto* label = new QLabel(tr("&Fabric"), contents);
    label->setBuddy(preset_);
    grid->addWidget(label, 1, 0);
    grid->addWidget(preset_, 1, 1, 1, 2);
    constexpr int kFitRow = 8, kLastRow = 14;
    addLimits(*grid);
    grid->addWidget(
        makeWrappedNote(
            tr("Presets are rules of thumb. For exact limits, measure a sample and enter them."),
            "fabricNote", this),
        6, 0, 1, 3);
    limitWidgets_ = widgetsOfRows(*grid, 2, kFitRow - 1);
    addFit(*grid, kFitRow);
    fitWidgets_ = widgetsOfRows(*grid, kFitRow, kLastRow);
    unstated_ =
        makeWrappedNote(tr("No fabric set. Choose one to see where it is strained too far."),
                        "fabricUnstated", this);
    grid->addWidget(unstated_, kLastRow, 0, 1, 3);
    addCloth(*grid, kLastRow + 1);
    return contents;
}

void FabricPanel::addCloth(QGridLayout& grid, int row) {
    fields_.addRow(grid, "width", row);
    need_ = makeWrappedNote({}, "fabricNeed", this);
    need_->setToolTip(
        tr("Box around one of each piece in this fabric, with allowances, grain upwards"));
    grid.addWidget(need_, row + 1, 0, 1, 3);
    grid.setRowStretch(row + 2, 1);
}

void FabricPanel::addLimits(QGridLayout& grid) {
    auto* least = new QLabel(tr("Shrinks"), this);
    auto* most = new QLabel(tr("Stretches"), this);
    least->setToolTip(fields_.at("warpLeast").toolTip());
    most->setToolTip(fields_.at("warpMost").toolTip());
    for (QLabel* heading : {least, most}) {
        heading->setForegroundRole(QPalette::PlaceholderText);
    }
    grid.addWidget(least, 2, 1, Qt::AlignRight);
    grid.addWidget(most, 2, 2, Qt::AlignRight);
    const std::tuple<const char*, QString, QString> directions[] = {
        {"warp", tr("Warp"), tr("Along the grain")},
        {"weft", tr("Weft"), tr("Across the grain")},
        {"bias", tr("Bias"), tr("At 45° to the grain")}};
    int row = 3;
    for (const auto& [key, title, tip] : directions) {
        auto* label = new QLabel(title, this);
        label->setToolTip(tip);
        grid.addWidget(label, row, 0);
        int column = 1;
        for (const char* end : {"Least", "Most"}) {
            QWidget& field = fields_.at(std::string(key) + end);
            field.setMinimumWidth(76);
            grid.addWidget(&field, row, column++);
        }
        ++row;
    }
}

void FabricPanel::addFit(QGridLayout& grid, int row) {
    auto* heading = makeHeading(tr("Over the limits"), this);
    heading->setToolTip(tr(
        "Share of the cloth strained beyond these limits, as shown at the overlay's colour bar"));
    grid.addWidget(heading, row++, 0, 1, 3);
    const char* const names[] = {"fabricBeyondWarp", "fabricBeyondWeft", "fabricBeyondBias"};
    const auto connectLink = [this](QLabel* label) {
        label->setTextInteractionFlags(Qt::LinksAccessibleByMouse | Qt::LinksAccessibleByKeyboard);
        connect(label, &QLabel::linkActivated, this, &FabricPanel::follow);
    };
    for (std::size_t k = 0; k < shares_.size(); ++k) {
        directions_[k] = new QLabel(this);
        directions_[k]->setToolTip(tr("Show the strain in this direction"));
        connectLink(directions_[k]);
        shares_[k] = new QLabel(this);
        shares_[k]->setObjectName(names[k]);
        grid.addWidget(directions_[k], row, 0);
        grid.addWidget(shares_[k], row++, 1, Qt::AlignRight);
    }
    showDirections();
    auto* any = new QLabel(tr("Any"), this);
    any->setToolTip(
        tr("In at least one of the three directions. Edge strain differs: it applies the tightest "
           "limit to every edge."));
    grid.addWidget(any, row, 0);
    all_->setObjectName("fabricBeyondAny");
    grid.addWidget(all_, row++, 1, Qt::AlignRight);
    worst_->setObjectName("fabricWorst");
    worst_->setWordWrap(true);
    connectLink(worst_);
    grid.addWidget(worst_, row, 0, 1, 3);
}

void FabricPanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && directions_.back()) {
        // A label keeps the link colours from when its text was set, so set the texts again.
        for (QLabel* label : {directions_[0], directions_[1], directions_[2], worst_}) {
            label->clear();
        }
        showDirections();
        showFit();
    }
}

void FabricPanel::showDirections() {
    const QString titles[] = {tr("Warp"), tr("Weft"), tr("Bias")};
    for (std::size_t k = 0; k < directions_.size(); ++k) {
        directions_[k]->setText(linked(titles[k], kLinks[k]));
    }
}

void FabricPanel::onChanged(const DocumentChange& what) {
    if (what.hasOtherPieces() || what.touches(&DocumentState::fabric, &DocumentState::materials)) {
        refresh();
    } else if (what.touchesContent()) {
        showNeed();
    }
    askForFit();
}

void FabricPanel::showNeed() {
    need_->hide();
    const auto pattern = document_.derived().pattern;
    if (!pattern) {
        return;
    }
    const LaidOutPattern laid = cutAndPlace(*pattern, document_.settings(),
                                            document_.state().materials, document_.fabric());
    for (const ClothNeed& need : clothNeeds(laid, document_.fabric())) {
        if (need.material == shown_) {
            need_->setText(need.fits() ? tr("%1 at this width").arg(saidLength(need.length))
                                       : tr("The pieces are %1 wide, wider than the fabric")
                                             .arg(saidLength(need.across)));
            need_->show();
        }
    }
}

void FabricPanel::askForFit() {
    if (!document_.scene()) {
        setFit(std::nullopt);  // clear the figures of a closed garment
    }
    follower_.ask({document_.scene(),
                   placesOf(document_.settings(), {}, document_.state().materials),
                   document_.fabric()});
}

void FabricPanel::setFit(const std::optional<FabricFit>& fit, const QString& problem) {
    if (fit != fit_ || problem != problem_) {
        fit_ = fit;
        problem_ = problem;
        showFit();
    }
}

void FabricPanel::showMaterials() {
    const MaterialList& materials = document_.state().materials;
    shown_ = findMaterial(shown_, materials) ? shown_ : std::string();
    material_->clear();
    material_->addItem(tr("Garment"));
    for (const Material& material : materials) {
        const QString name = QString::fromStdString(material.name);
        material_->addItem(name, name);
    }
    material_->setCurrentIndex(
        std::max(0, material_->findData(QString::fromStdString(shown_), Qt::UserRole,
                                        Qt::MatchExactly | Qt::MatchCaseSensitive)));
    material_->setVisible(!materials.empty());
    materialTitle_->setVisible(!materials.empty());
}

Fabric& FabricPanel::shownFabric(DocumentState& state) const {
    const auto found = std::ranges::find(state.materials, shown_, &Material::name);
    return found == state.materials.end() ? state.fabric : found->fabric;
}

void FabricPanel::refresh() {
    pages_->setCurrentIndex(document_.garment() ? 0 : 1);
    showMaterials();
    const Fabric& fabric = fabricOf(shown_, document_.state().materials, document_.fabric());
    preset_->setCurrentIndex(rowOf(fabric));
    fields_.show(kLimitFields, fabric);
    const bool isStated = hasLimits(fabric);
    setShown(limitWidgets_, isStated);
    unstated_->setVisible(!isStated);
    setShown(fitWidgets_, hasLimits(document_.fabric()) ||
                              std::ranges::any_of(document_.state().materials,
                                                  [](const Material& material) -> bool {
                                                      return hasLimits(material.fabric);
                                                  }));
    showFit();
    showNeed();
}

void FabricPanel::showFit() {
    const QString unknown(QChar(0x2013));
    const double shares[] = {fit_ ? fit_->warp : 0, fit_ ? fit_->weft : 0, fit_ ? fit_->bias : 0};
    for (std::size_t k = 0; k < shares_.size(); ++k) {
        shares_[k]->setText(fit_ ? shareText(shares[k]) : unknown);
    }
    all_->setText(fit_ ? shareText(fit_->any) : unknown);
    if (!fit_ || !document_.garment()) {
        worst_->setText(problem_.isEmpty() ? tr("No flat pieces yet.") : problem_.toHtmlEscaped());
        return;
    }
    if (!fit_->worst || fit_->worst->piece >= document_.pieceCount()) {
        worst_->setText(tr("All strain is within the fabric's limits."));
        return;
    }
    const QString name = pieceName(document_, fit_->worst->piece);
    worst_->setText(tr("Worst: %1, %2 of its area")
                        .arg(linked(name, kPieceLink), shareText(fit_->worst->share)));
}

void FabricPanel::choosePreset(int index) {
    if (!document_.garment()) {
        return;
    }
    DocumentState next = document_.state();
    const auto presets = fabricPresets();
    Fabric& fabric = shownFabric(next);
    if (index >= 0 && index < static_cast<int>(presets.size())) {
        // Keep a typed width.
        const Fabric* before = presetOf(fabric);
        const double width = fabric.width;
        fabric = presets[static_cast<std::size_t>(index)];
        fabric.width = before && before->width == width ? fabric.width : width;
    } else {
        // Start from woven limits rather than from 0.
        fabric = hasLimits(fabric) ? fabric : *fabricPreset("woven");
        fabric.id = kCustom;
    }
    const QString name = fabricName(fabric);
    const QString text = shown_.empty()
                             ? tr("Set fabric: %1").arg(name)
                             : tr("Set fabric of %1: %2").arg(QString::fromStdString(shown_), name);
    document_.edit(text, std::move(next));
    refresh();
}

void FabricPanel::take(const SettingChange& change) {
    if (document_.garment()) {
        DocumentState next = document_.state();
        Fabric& fabric = shownFabric(next);
        fabric = fields_.changed(kLimitFields, fabric, change);
        const bool isLimit = change.path != "width";
        fabric.id = isLimit ? kCustom : fabric.id;
        document_.edit(isLimit ? tr("Set fabric limits") : change.text, std::move(next),
                       change.gesture);
        refresh();
    }
}

void FabricPanel::follow(const QString& link) {
    if (link == kPieceLink) {
        if (fit_ && fit_->worst) {
            document_.setSelection({fit_->worst->piece});
            emit pieceActivated();
        }
        return;
    }
    for (std::size_t k = 0; k < std::size(kLinks); ++k) {
        if (link == kLinks[k]) {
            document_.setOverlay(kDirections[k]);
        }
    }
}

}  // namespace toile::app
