// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/marker/marker_window.h"

#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLocale>
#include <QPointer>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QShowEvent>
#include <QStringList>
#include <algorithm>

#include "app/actions/file_dialogs.h"
#include "app/actions/own_folders.h"
#include "app/base/text.h"
#include "app/marker/cloth_view.h"
#include "app/marker/marker_form.h"
#include "app/session/workspace.h"
#include "app/settings/length_display.h"
#include "app/settings/preferences.h"
#include "app/text/error_text.h"
#include "app/text/figures.h"
#include "app/widgets/field_keys.h"
#include "app/widgets/scrolled.h"
#include "core/formats/drawing/marker_drawing.h"
#include "core/formats/export_file.h"
#include "core/formats/formats.h"
#include "core/formats/hide_file.h"

namespace toile::app {

namespace {

constexpr double kUsualRate = 3;  // minutes per metre of seam
constexpr FormatId kPageFormats[] = {FormatId::Pdf, FormatId::Svg, FormatId::Dxf, FormatId::Plt,
                                     FormatId::Png};

QString metres(double value) {
    return saidLength(1000 * value);
}

/// Filter of the file dialog: "PDF (*.pdf);;SVG (*.svg)".
QString pageFilter() {
    QStringList filters;
    for (const FormatId id : kPageFormats) {
        const Format& format = formatOf(id);
        if (format.write) {
            filters << QString("%1 (*%2)")
                           .arg(QString::fromUtf8(format.endings.front()).mid(1).toUpper(),
                                QString::fromUtf8(format.endings.front()));
        }
    }
    return filters.join(";;");
}

QString wholePercent(double share) {
    return QLocale().toString(100 * share, 'f', 1);
}

}  // namespace

MarkerWindow::MarkerWindow(Workspace& workspace, Preferences& preferences, FileDialogs& files,
                           QWidget* parent)
    : QDialog(parent),
      preferences_(preferences),
      files_(files),
      desk_(workspace),
      form_(new MarkerForm(desk_, this)),
      view_(new ClothView(desk_, this)),
      figures_(new QLabel(this)),
      details_(new QLabel(this)),
      notes_(new QLabel(this)),
      said_(new QLabel(this)),
      rate_(new QDoubleSpinBox(this)),
      improve_(new QPushButton(this)),
      again_(new QPushButton(tr("Start a&gain"), this)),
      save_(new QPushButton(tr("Sa&ve marker…"), this)) {
    setObjectName("markerWindow");
    setWindowTitle(tr("Marker"));
    setSizeGripEnabled(true);
    auto* scrolled = scrolledColumn(*form_, this);
    scrolled->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Expanding);
    scrolled->setMinimumWidth(form_->sizeHint().width() + 18);
    auto* keys = new FieldKeys([this] { view_->setFocus(); }, this);
    keys->watch(*form_);
    auto* layout = new QGridLayout(this);
    layout->addWidget(scrolled, 0, 0);
    layout->addWidget(view_, 0, 1);
    layout->addLayout(makeFigures(), 1, 0, 1, 2);
    layout->setColumnStretch(1, 1);
    layout->setRowStretch(0, 1);
    connect(&desk_, &MarkerDesk::changed, this, &MarkerWindow::refresh);
    connect(&desk_, &MarkerDesk::failed, this, &MarkerWindow::say);
    connect(view_, &ClothView::said, this, &MarkerWindow::say);
    connect(form_, &MarkerForm::hidesWanted, this, &MarkerWindow::chooseHides);
    connect(&LengthDisplay::instance(), &LengthDisplay::changed, this, &MarkerWindow::refresh);
    connect(rate_, &QDoubleSpinBox::valueChanged, this, [this](double minutes) {
        preferences_.setSewingRate(minutes);
        refresh();
    });
    resize(QSize(1280, 800).boundedTo(screen()->availableSize() * 0.95));
    refresh();
}

MarkerWindow::~MarkerWindow() {
    hide();  // may commit a half-typed value, which needs the desk
    desk_.disconnect();
    delete form_;
    delete view_;
    delete rate_;
}

QLayout* MarkerWindow::makeFigures() {
    figures_->setObjectName("markerFigures");
    QFont strong = figures_->font();
    strong.setWeight(QFont::DemiBold);
    strong.setPointSizeF(1.15 * strong.pointSizeF());
    figures_->setFont(strong);
    details_->setObjectName("markerDetails");
    notes_->setObjectName("markerNotes");
    notes_->setWordWrap(true);
    said_->setObjectName("markerSaid");
    said_->setWordWrap(true);
    said_->hide();
    rate_->setObjectName("markerRate");
    rate_->setRange(0, 999);
    rate_->setDecimals(1);
    rate_->setValue(preferences_.sewingRate().value_or(kUsualRate));
    rate_->setSuffix(tr(" min/m"));
    rate_->setToolTip(tr("Your sewing time per metre of seam"));
    rate_->setAccessibleName(tr("Minutes per metre of seam"));
    auto* details = new QHBoxLayout;
    details->addWidget(details_);
    details->addWidget(rate_);
    details->addStretch(1);
    auto* words = new QVBoxLayout;
    words->addWidget(figures_);
    words->addLayout(details);
    words->addWidget(notes_);
    words->addWidget(said_);
    auto* row = new QHBoxLayout;
    row->addLayout(words, 1);
    row->addLayout(makeButtons());
    return row;
}

QLayout* MarkerWindow::makeButtons() {
    improve_->setObjectName("markerImprove");
    again_->setObjectName("markerAgain");
    again_->setToolTip(tr("Discard the result and search again; pieces placed by hand stay"));
    save_->setObjectName("markerSave");
    save_->setToolTip(tr("Save the marker as PDF, SVG, DXF, PLT or PNG"));
    for (QPushButton* button : {improve_, again_, save_}) {
        button->setAutoDefault(false);
    }
    connect(improve_, &QPushButton::clicked, this,
            [this] { desk_.isRunning() ? desk_.stop() : desk_.improve(); });
    connect(again_, &QPushButton::clicked, this, [this] { desk_.startAgain(); });
    connect(save_, &QPushButton::clicked, this, &MarkerWindow::save);
    auto* row = new QHBoxLayout;
    row->addWidget(improve_);
    row->addWidget(again_);
    row->addWidget(save_);
    row->setAlignment(Qt::AlignBottom);
    return row;
}

void MarkerWindow::reject() {
    if (!view_->isDragging()) {  // Escape only cancels the drag
        QDialog::reject();
    }
}

void MarkerWindow::showEvent(QShowEvent* event) {
    QDialog::showEvent(event);
    if (!event->spontaneous()) {
        view_->frameAll();
        view_->setFocus();
        desk_.begin();
    }
}

void MarkerWindow::hideEvent(QHideEvent* event) {
    QDialog::hideEvent(event);
    if (!event->spontaneous()) {
        desk_.end();
    }
}

void MarkerWindow::keyPressEvent(QKeyEvent* event) {
    const bool isEnter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (!isEnter) {  // Enter has committed the field, and must not press a button
        QDialog::keyPressEvent(event);
    }
}

void MarkerWindow::refresh() {
    const ClothMarker* marker = desk_.marker();
    // A failed layout has no figures, even if an earlier one is shown.
    const bool hasFigures = marker && desk_.stage() != MarkerDesk::Stage::Failed;
    figures_->setText(hasFigures ? figuresText() : QString());
    details_->setText(hasFigures ? detailsText() : QString());
    rate_->setVisible(hasFigures);
    const QString notes = notesText();
    notes_->setText(notes);
    notes_->setVisible(!notes.isEmpty());
    improve_->setText(desk_.isRunning() ? tr("&Stop") : tr("&Improve"));
    improve_->setToolTip(desk_.isRunning() ? tr("Stop and keep the best marker found")
                                           : tr("Search for a shorter marker until you stop"));
    improve_->setEnabled(desk_.isRunning() || desk_.canImprove());
    again_->setEnabled(desk_.stage() == MarkerDesk::Stage::Laid ||
                       desk_.stage() == MarkerDesk::Stage::Failed);
    save_->setEnabled(desk_.isCurrent() && desk_.misplaced().empty());
    save_->setToolTip(
        !marker || save_->isEnabled() ? tr("Save the marker as PDF, SVG, DXF, PLT or PNG")
        : desk_.isCurrent()
            ? tr("First move the red pieces so that none overlaps or leaves the cloth")
            : tr("The search has not applied your settings yet"));
}

void MarkerWindow::say(const QString& sentence) {
    said_->setText(sentence);
    said_->setVisible(!sentence.isEmpty());
}

QString MarkerWindow::figuresText() const {
    const ClothMarker& marker = *desk_.marker();
    const int misplaced = static_cast<int>(desk_.misplaced().size());
    if (misplaced > 0) {
        return misplaced == 1
                   ? tr("1 piece overlaps another or leaves the cloth")
                   : tr("%n pieces overlap others or leave the cloth", nullptr, misplaced);
    }
    if (!marker.isRoll && !marker.areHides) {
        return (marker.sheets == 1 ? tr("1 sheet, %1 % used")
                                   : tr("%n sheets, %1 % used", nullptr, marker.sheets))
            .arg(wholePercent(marker.use));
    }
    if (marker.areHides) {
        return (marker.sheets == 1 ? tr("1 hide, %1 % used")
                                   : tr("%n hides, %1 % used", nullptr, marker.sheets))
            .arg(wholePercent(marker.use));
    }
    return (desk_.settings().isFolded ? tr("%1 of cloth, folded to %2, %3 % used")
                                      : tr("%1 of cloth, %2 wide, %3 % used"))
        .arg(saidLength(marker.length), saidLength(marker.width), wholePercent(marker.use));
}

QString MarkerWindow::detailsText() const {
    const MarkerFigures& figures = desk_.figures();
    const QLocale locale;
    const double minutes = figures.seamMetres * rate_->value();
    const int rounds = desk_.marker()->rounds;
    QStringList parts{
        figures.copies == 1 ? tr("1 piece") : tr("%n pieces", nullptr, figures.copies),
        rounds == 1 ? tr("1 search round") : tr("%n search rounds", nullptr, rounds),
        tr("%1 to cut").arg(metres(figures.cutMetres)),
        figures.notches == 1 ? tr("1 notch") : tr("%n notches", nullptr, figures.notches),
        tr("%1 of seams: %2 min at")
            .arg(metres(figures.seamMetres), locale.toString(minutes, 'f', 0)),
    };
    return parts.join(QString::fromUtf8(" · "));
}

QString MarkerWindow::notesText() const {
    QStringList lines;
    if (const QString problem = desk_.problem();
        !problem.isEmpty() && (desk_.marker() || desk_.stage() == MarkerDesk::Stage::Failed)) {
        lines << problem;
    }
    if (desk_.marker()) {
        for (const Wording& note : desk_.marker()->notes) {
            lines << wordingText(note);
        }
    }
    return lines.join('\n');
}

/// Reads the chosen hides; they replace the previous ones.
void MarkerWindow::chooseHides() {
    const QStringList paths = files_.openHides(this, preferences_.openFolder());
    MarkerSettings settings = desk_.settings();
    settings.hides.clear();
    QStringList sentences;
    for (const QString& path : paths) {
        const Result<HideFile> read = readHide(pathOf(path));
        if (!read) {
            sentences << errorText(read.error());
            continue;
        }
        settings.hides.push_back(std::make_shared<const Hide>(read->hide));
        for (const Wording& note : read->notes) {
            sentences << QFileInfo(path).fileName() + ": " + wordingText(note);
        }
    }
    say(sentences.join('\n'));
    if (!settings.hides.empty()) {
        settings.sheet.reset();
        settings.isFolded = false;
        desk_.setSettings(tr("Choose hides"), settings);
    }
    form_->showAgain();
}

void MarkerWindow::save() {
    if (!desk_.isCurrent() || !desk_.ground()) {
        return;
    }
    const auto& source = desk_.document().garment()->files.front()->path;
    const QString remembered = preferences_.exportFolder();
    const QString folder =
        remembered.isEmpty() ? writingFolder(textOf(source), QString()) : remembered;
    QString name = tr("%1-marker").arg(QFileInfo(textOf(source)).completeBaseName());
    if (!desk_.material().empty()) {
        name += '-' + QString::fromStdString(desk_.material());
    }
    const QString path = files_.save(this, folder + '/' + name + ".pdf", pageFilter());
    if (path.isEmpty()) {
        return;
    }
    if (!holdsMarkers(pathOf(path))) {
        say(tr("Choose a file name that ends in .pdf, .svg, .dxf, .plt or .png."));
        return;
    }
    // The marker may have changed while the file dialog was open.
    const ClothMarker* marker = desk_.marker();
    if (!desk_.isCurrent() || !desk_.ground() || !desk_.misplaced().empty()) {
        say(tr("Not saved: the marker changed meanwhile. Save it again."));
        return;
    }
    preferences_.setExportFolder(QFileInfo(path).absolutePath());
    MarkerSheet sheet{desk_.ground(), desk_.pattern(), *marker, desk_.settings(), {}};
    sheet.title = {desk_.document().title().toStdString(),
                   wordingText(clothSentence(*marker)).toStdString()};
    desk_.workspace().writing().start(markerFileJob(
        std::move(sheet), pathOf(path), preferences_.exportOptions(),
        [this, alive = QPointer<MarkerWindow>(this)](const Exported& written) {
            if (alive) {
                QString text =
                    tr("Saved: %1").arg(QFileInfo(textOf(written.files.front())).fileName());
                for (const Wording& note : written.notes) {
                    text += "; " + wordingText(note);
                }
                say(text);
            }
        }));
}

}  // namespace toile::app
