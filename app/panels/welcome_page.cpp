// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/welcome_page.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QIcon>
#include <QKeyEvent>
#include <QLabel>
#include <QLocale>
#include <QPainter>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "app/actions/own_folders.h"
#include "app/settings/preferences.h"
#include "app/widgets/icon.h"

namespace toile::app {

namespace {

constexpr int kColumnWidth = 620;
constexpr int kRecentShown = 6;
constexpr int kPad = 10, kRowGap = 12;
constexpr QSize kSamplePicture(96, 96);
constexpr const char* kFaint = "faintText";

QLabel* makeText(const QString& text, double scale, bool bold, bool faint) {
    auto* label = new QLabel(text);
    label->setAlignment(Qt::AlignHCenter);
    label->setWordWrap(true);
    QFont font = label->font();
    font.setPointSizeF(font.pointSizeF() * scale);
    if (bold) {
        font.setWeight(QFont::DemiBold);
    }
    label->setFont(font);
    if (faint) {
        label->setObjectName(kFaint);
    }
    return label;
}

/// A recent file: its name, its folder, and when it was changed.
class RecentFileButton : public QPushButton {
public:
    explicit RecentFileButton(const QString& path);

    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QString folder_, date_;
};

RecentFileButton::RecentFileButton(const QString& path) {
    const QFileInfo file(path);
    setText(file.fileName());
    folder_ = QDir::toNativeSeparators(file.absolutePath());
    const QString home = QDir::toNativeSeparators(QDir::homePath());
    if (folder_.startsWith(home)) {
        folder_.replace(0, home.size(), "~");
    }
    date_ = QLocale().toString(file.lastModified().date(), QLocale::ShortFormat);
    setToolTip(QDir::toNativeSeparators(path));
    setAccessibleDescription(folder_);
    setFlat(true);
    setCursor(Qt::PointingHandCursor);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

QSize RecentFileButton::sizeHint() const {
    return {200, fontMetrics().height() + 14};
}

void RecentFileButton::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const bool lit = underMouse() || hasFocus();
    if (lit) {
        QColor back = palette().color(QPalette::Highlight);
        back.setAlphaF(0.14F);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(hasFocus() ? QPen(palette().color(QPalette::Highlight)) : QPen(Qt::NoPen));
        painter.setBrush(back);
        painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
    }
    QRect row = rect().adjusted(kPad, 0, -kPad, 0);
    const QColor ink = palette().color(QPalette::WindowText);
    const QColor faint = palette().color(QPalette::PlaceholderText);
    painter.setPen(faint);
    painter.drawText(row, Qt::AlignRight | Qt::AlignVCenter, date_);
    row.setRight(row.right() - fontMetrics().horizontalAdvance(date_) - kRowGap);
    const QString name = fontMetrics().elidedText(text(), Qt::ElideMiddle, row.width());
    painter.setPen(ink);
    painter.drawText(row, Qt::AlignLeft | Qt::AlignVCenter, name);
    row.setLeft(row.left() + fontMetrics().horizontalAdvance(name) + kRowGap);
    painter.setPen(faint);
    painter.drawText(row, Qt::AlignLeft | Qt::AlignVCenter,
                     fontMetrics().elidedText(folder_, Qt::ElideMiddle, row.width()));
}

/// Display name of a sample; an unknown sample gets its file name.
QString sampleTitle(const QString& path) {
    constexpr std::pair<const char*, const char*> kTitles[] = {
        {"bodice", QT_TRANSLATE_NOOP("WelcomePage", "Bodice")},
        {"cap", QT_TRANSLATE_NOOP("WelcomePage", "Cap")},
        {"skirt", QT_TRANSLATE_NOOP("WelcomePage", "Skirt")},
        {"trousers", QT_TRANSLATE_NOOP("WelcomePage", "Trousers")},
        {"tshirt", QT_TRANSLATE_NOOP("WelcomePage", "T-shirt")},
    };
    const QString base = QFileInfo(path).completeBaseName();
    for (const auto& [name, title] : kTitles) {
        if (base == QLatin1String(name)) {
            return QCoreApplication::translate("WelcomePage", title);
        }
    }
    QString title = base;
    title.replace('_', ' ').replace('-', ' ');
    return title.left(1).toUpper() + title.mid(1);
}

}  // namespace

WelcomePage::WelcomePage(Preferences& preferences, QWidget* parent)
    : QWidget(parent), preferences_(preferences) {
    setObjectName("welcome");
    auto* mark = new QLabel;
    mark->setPixmap(QIcon(":/icons/toile.svg").pixmap(QSize(76, 76), devicePixelRatioF()));
    mark->setAlignment(Qt::AlignHCenter);
    mark->setMinimumHeight(76);
    open_ = new QPushButton(themedIcon("open"), tr("Open a garment…"), this);
    open_->setObjectName("welcomeOpen");
    open_->setDefault(true);
    open_->setMinimumHeight(38);
    open_->setIconSize({20, 20});
    connect(open_, &QPushButton::clicked, this, &WelcomePage::openWanted);

    auto* column = new QWidget;
    column->setFixedWidth(kColumnWidth);
    auto* lines = new QVBoxLayout(column);
    lines->setSpacing(8);
    lines->addWidget(mark);
    lines->addSpacing(16);
    lines->addWidget(makeText(tr("From a 3D garment to a sewing pattern"), 1.7, true, false));
    lines->addWidget(makeText(tr("Toile flattens every piece of a garment, keeps the length of its "
                                 "seam lines, and shows the strain of the cloth."),
                              1.05, false, true));
    lines->addSpacing(16);
    lines->addWidget(open_, 0, Qt::AlignHCenter);
    advice_ = makeText(tr("or drop OBJ, .zip, glTF, FBX, USD, PLY, STL or .toile files here; "
                          "several meshes form one garment"),
                       0.95, false, true);
    lines->addWidget(advice_);
    lines->addWidget(makeOrigins(), 0, Qt::AlignHCenter);
    lines->addWidget(makeRecent());
    if (QWidget* samples = makeSamples()) {
        lines->addSpacing(22);
        lines->addWidget(makeText(tr("Or start with a sample"), 1.0, true, false));
        lines->addWidget(samples, 0, Qt::AlignHCenter);
    }
    auto* layout = new QVBoxLayout(this);
    // Stretches, not an alignment: with one, the layout ignores height-for-width of the texts.
    auto* middle = new QHBoxLayout;
    middle->addStretch(1);
    middle->addWidget(column);
    middle->addStretch(1);
    layout->addStretch(2);
    layout->addLayout(middle);
    layout->addStretch(3);
    tintFaintTexts();
}

void WelcomePage::tintFaintTexts() {
    QColor colour = palette().color(QPalette::WindowText);
    colour.setAlphaF(0.70F);
    for (QLabel* label : findChildren<QLabel*>(kFaint)) {
        QPalette tinted;
        tinted.setColor(QPalette::WindowText, colour);
        label->setPalette(tinted);
    }
}

QWidget* WelcomePage::makeOrigins() {
    const struct {
        const char* name;
        QString title, advice;
    } kOrigins[] = {
        {"originClo", tr("CLO, Marvelous Designer"),
         tr("Export as OBJ: all patterns, thin, in mm or cm, with the UV map. Toile gets the "
            "panels from the map.")},
        {"originBlender", tr("Blender"),
         tr("Select the garment and export it as Wavefront OBJ, with modifiers applied and UV "
            "coordinates. If you marked seams and unwrapped, split by UV islands.")},
        {"originGame", tr("Game or character"),
         tr("Export only the garment as OBJ with its UV map. Enter its height when Toile asks. If "
            "the texture map is not split like cloth, draw cuts.")},
        {"originScan", tr("Scan"),
         tr("Save only the garment as PLY, STL or OBJ, cleaned and reduced to about 100,000 "
            "triangles. A scan has no seams: draw them as cuts.")},
    };
    auto* box = new QWidget;
    box->setObjectName("origins");
    auto* row = new QHBoxLayout(box);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    for (const auto& origin : kOrigins) {
        auto* button = new QToolButton;
        button->setObjectName(origin.name);
        button->setText(origin.title);
        button->setToolTip(origin.advice);
        button->setCheckable(true);
        button->setAutoExclusive(true);
        button->setAutoRaise(true);
        connect(button, &QToolButton::clicked, this,
                [this, advice = origin.advice] { advice_->setText(advice); });
        row->addWidget(button);
    }
    return box;
}

QWidget* WelcomePage::makeSamples() {
    const QStringList paths = samplePaths();
    if (paths.isEmpty()) {
        return nullptr;
    }
    auto* box = new QWidget;
    auto* row = new QHBoxLayout(box);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(8);
    for (const QString& path : paths) {
        const QFileInfo file(path);
        auto* button = new QToolButton;
        button->setText(sampleTitle(path));
        button->setObjectName("sample-" + file.completeBaseName());
        button->setToolTip(QDir::toNativeSeparators(path));
        button->setMinimumWidth(92);
        button->setMinimumHeight(32);
        const QPixmap picture(file.dir().filePath(file.completeBaseName() + ".png"));
        if (!picture.isNull()) {
            button->setIcon(QIcon(picture));
            button->setIconSize(kSamplePicture);
            button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
        }
        connect(button, &QToolButton::clicked, this, [this, path] { emit filesWanted({path}); });
        row->addWidget(button);
    }
    return box;
}

QWidget* WelcomePage::makeRecent() {
    recent_ = new QWidget;
    recent_->setObjectName("recentFiles");
    recentRows_ = new QVBoxLayout(recent_);
    recentRows_->setContentsMargins(0, 20, 0, 0);
    recentRows_->setSpacing(2);
    connect(&preferences_, &Preferences::recentFilesChanged, this, &WelcomePage::updateRecent);
    updateRecent();
    return recent_;
}

void WelcomePage::updateRecent() {
    while (QLayoutItem* row = recentRows_->takeAt(0)) {
        if (QWidget* widget = row->widget()) {
            widget->hide();
            widget->deleteLater();  // it may be the sender of this click
        }
        delete row;
    }
    int shown = 0;
    const QList<QStringList> recent = preferences_.recentFiles();
    QWidget* before = open_;  // the tab order goes down the page
    for (const QStringList& files : recent) {
        const bool there = std::all_of(files.begin(), files.end(),
                                       [](const QString& path) { return QFileInfo::exists(path); });
        if (shown == kRecentShown || !there) {
            continue;
        }
        if (shown == 0) {
            recentRows_->addWidget(makeText(tr("Recent files"), 1.0, true, false));
            recentRows_->addSpacing(4);
        }
        auto* button = new RecentFileButton(files.front());
        button->setObjectName(QString("recent-%1").arg(++shown));
        connect(button, &QPushButton::clicked, this, [this, files] { emit filesWanted(files); });
        recentRows_->addWidget(button);
        if (window() == button->window()) {  // false while the page is being made
            setTabOrder(before, button);
            before = button;
        }
    }
    recent_->setVisible(shown > 0);
}

void WelcomePage::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) {
        tintFaintTexts();
    }
}

void WelcomePage::keyPressEvent(QKeyEvent* event) {
    auto* button = qobject_cast<QAbstractButton*>(focusWidget());
    if (button && (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)) {
        button->click();
        return;
    }
    QWidget::keyPressEvent(event);
}

void WelcomePage::showEvent(QShowEvent* event) {
    updateRecent();  // files may have been deleted meanwhile
    QWidget::showEvent(event);
}

}  // namespace toile::app
