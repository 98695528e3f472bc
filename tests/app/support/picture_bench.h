// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QtGlobal>
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "app/document/document.h"
#include "app/document/layout.h"
#include "app/jobs/derivation.h"
#include "app/render/colour_map.h"
#include "app/render/morph.h"
#include "app/render/offscreen.h"
#include "app/render/overlay_values.h"
#include "app/render/scene_builder.h"
#include "app/settings/theme.h"
#include "app/views/ruler.h"
#include "app/views/view_picture.h"
#include "tests/app/support/garments.h"
#include "tests/app/support/moment.h"
#include "tests/core/support/laid_rows.h"

namespace toile::test {

using namespace app;

inline constexpr int kSameColour = 6;
/// Tolerance for the colour of a line, whose edge is blended with the background.
inline constexpr int kLineColour = 20;
inline constexpr double kMax = 0.9, kSamePicture = 0.02;
inline constexpr QSize kSize(700, 600);

inline QColor colourOf(Rgb rgb) {
    return {rgb.r, rgb.g, rgb.b};
}

inline int distance(QRgb a, QRgb b) {
    return std::max({std::abs(qRed(a) - qRed(b)), std::abs(qGreen(a) - qGreen(b)),
                     std::abs(qBlue(a) - qBlue(b))});
}

/// Share of the pixels that a viewer could tell apart; 1 if the sizes differ.
inline double differing(const QImage& a, const QImage& b, int steps = 24) {
    if (a.size() != b.size() || a.isNull()) {
        return 1;
    }
    int count = 0;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            count += distance(a.pixel(x, y), b.pixel(x, y)) > steps;
        }
    }
    return count / double(a.width() * a.height());
}

/// A piece with the given flat coordinates.
inline std::shared_ptr<const PieceResult> resultOf(const std::shared_ptr<const Piece>& piece,
                                                   Points2 flat, const FlattenOptions& options) {
    auto result = std::make_shared<PieceResult>();
    result->piece = piece;
    result->flat = FlatPiece{};
    result->flat->Q = std::move(flat);
    result->quality = measure(*piece, result->flat->Q);
    result->options = options;
    return result;
}

/// A round cap of a sphere, bulging to +z, its rim in the plane z = 0.
inline MeshArrays makeRoundCap(double radius, double opening, int rings, int sectors) {
    MeshArrays mesh;
    mesh.V.resize(1 + rings * sectors, 3);
    mesh.F.resize(sectors * (2 * rings - 1), 3);
    mesh.V.row(0) << 0, 0, radius * (1 - std::cos(opening));
    int face = 0;
    const auto at = [&](int ring, int sector) { return 1 + ring * sectors + sector % sectors; };
    for (int r = 0; r < rings; ++r) {
        const double angle = opening * (r + 1) / rings;
        for (int s = 0; s < sectors; ++s) {
            const double turn = 2 * std::numbers::pi * s / sectors;
            mesh.V.row(at(r, s)) << radius * std::sin(angle) * std::cos(turn),
                radius * std::sin(angle) * std::sin(turn),
                radius * (std::cos(angle) - std::cos(opening));
            if (r == 0) {
                mesh.F.row(face++) << 0, at(0, s), at(0, s + 1);
            } else {
                mesh.F.row(face++) << at(r - 1, s), at(r, s), at(r, s + 1);
                mesh.F.row(face++) << at(r - 1, s), at(r, s + 1), at(r - 1, s + 1);
            }
        }
    }
    return mesh;
}

/// A document to draw pictures of, with helpers for tests.
class PictureBench {
protected:
    std::unique_ptr<OffscreenContext> context_;
    std::unique_ptr<Document> document_;

    Document& document() { return *document_; }

    static PictureOptions options(ViewsShown views, QSize size = kSize) {
        PictureOptions made;
        made.size = size;
        made.views = views;
        made.direction = kFrontView;
        made.legend = false;
        made.font = QFont("Sans Serif", 9);
        made.palette = lightPalette();
        return made;
    }

    QImage draw(const PictureOptions& asked) {
        QString problem;
        QImage image = drawViews(document(), asked, problem);
        if (!problem.isEmpty()) {
            qWarning("%s", qPrintable(problem));
        }
        return image;
    }
    QImage draw(ViewsShown views) { return draw(options(views)); }

    void open(std::shared_ptr<const Garment> garment, PieceResults results) {
        document_ = std::make_unique<Document>();
        DocumentState state;
        state.fabric = *fabricPreset("neoprene");  // -4 to +20 % in all directions
        Derived derived;
        derived.garment = garment;
        derived.results = std::move(results);
        Progress progress;
        toile::app::draw(derived, progress);
        for (const auto& [piece, placement] : inRows(*garment, derived.results).marker.copies) {
            state.settings[garment->pieces[static_cast<std::size_t>(piece)]->id].placement =
                placement;
        }
        document_->open(std::move(state), std::move(derived));
        document_->setView(&ViewState::worstSpots, false);
        document_->setView(&ViewState::shaded, false);  // colours as they are in the map
        document_->setView(&ViewState::rulers, false);
    }

    /// A sheet of 200 x 120 mm facing the viewer, with its cloth stretched sideways by `stretch`.
    void openStretched(double stretch) {
        auto garment = test::makeGarment({{"front", test::makeSheet(200, 120, 20, 12)}});
        Points2 flat = garment->pieces[0]->mesh.V.leftCols<2>();
        flat.col(0) /= 1 + stretch;
        open(garment, {resultOf(garment->pieces[0], flat, {})});
    }

    void openFlattened(std::shared_ptr<const Garment> garment) {
        Progress progress;
        PieceResults results = flattenGarment(*garment, {}, progress);
        open(std::move(garment), std::move(results));
    }

    void setGrain(double radians) {
        DocumentState next = document().state();
        said(next, document(), 0).grain = radians;
        document().edit("Grain", std::move(next));
    }

    Camera2D patternCamera(QSize size = kSize) {
        Camera2D camera;
        camera.setViewport(size.width(), size.height());
        framePattern(camera, *document().scene(), placesOf(document().settings()), {0}, false);
        return camera;
    }

    Camera3D garmentCamera(QSize size = kSize) {
        Camera3D camera;
        camera.setViewport(size.width(), size.height());
        camera.setFreeEdges(Camera3D::kSliderRoom);
        camera.setDirection(0, 0);
        frameGarment(camera, *document().scene(), placesOf(document().settings()), {0}, 0);
        return camera;
    }

    /// Area of the only piece, less a margin and, in the pattern, less the quarter with its name.
    QRect inside(ViewsShown view, double rim = 5) {
        Eigen::Vector2d low, high;
        if (view == ViewsShown::Pattern) {
            const Eigen::AlignedBox2d box = boxOnSheet(document(), 0);
            low = patternCamera().toScreen({box.min().x() + rim, box.max().y() - rim});
            high = patternCamera().toScreen({box.max().x() - rim, box.center().y() + 15});
        } else {
            const auto& box = document().scene()->pieces[0].box;
            low = garmentCamera().project({box.min().x() + rim, box.max().y() - rim, 0});
            high = garmentCamera().project({box.max().x() - rim, box.min().y() + rim, 0});
        }
        return {QPoint(qCeil(low.x()), qCeil(low.y())), QPoint(qFloor(high.x()), qFloor(high.y()))};
    }

    /// Share of the pixels inside, away from the grain arrow, for which `counts` is true.
    template <class Counts>
    double shareInside(const QImage& image, ViewsShown view, const Counts& counts) {
        const QRect part = inside(view);
        const double middle = part.center().x();
        int all = 0, some = 0;
        for (int y = part.top(); y <= part.bottom(); ++y) {
            for (int x = part.left(); x <= part.right(); ++x) {
                if (std::abs(x - middle) > 14) {
                    ++all;
                    some += counts(image.pixel(x, y));
                }
            }
        }
        return all > 0 ? some / double(all) : 0;
    }

    double shareLike(ViewsShown view, const QColor& colour) {
        return shareInside(draw(view), view, [&](QRgb pixel) {
            return distance(pixel, colour.rgb()) <= kSameColour;
        });
    }

    QColor mapColour(Overlay overlay, double value) {
        const OverlayScale scale = overlayScale(*document().scene(), overlay, document().fabric());
        return colourOf(colourMap(overlay)[static_cast<std::size_t>(
            std::lround(scale.shade(value) * (kColourMapSize - 1)))]);
    }

    /// Share of the picture that has the colour of the cloth.
    double shareOfCloth(const PictureOptions& asked) {
        document().setOverlay(Overlay::None);
        document().setView(&ViewState::pieceColours, true);
        document().setView(&ViewState::seams, false);
        const QColor cloth = colourOf(pieceColour(0));
        const QImage image = draw(asked);
        int count = 0;
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x) {
                count += distance(image.pixel(x, y), cloth.rgb()) <= kSameColour;
            }
        }
        return count / double(image.width() * image.height());
    }
};

}  // namespace toile::test
