// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/formats/export_fixtures.h"

#include <clocale>
#include <cmath>
#include <limits>
#include <locale>
#include <numbers>

#include "core/mesh/edge_table.h"

namespace toile::test {
namespace {

struct CommaPunctuation : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }

    char do_thousands_sep() const override { return '.'; }

    std::string do_grouping() const override { return "\3"; }
};

/// A piece of triangles over positions of a file, scaled to millimetres.
std::shared_ptr<Piece> makePiece(const std::string& name, const SourceFile& file,
                                 std::vector<int> sourceVertex, const Triangles& F,
                                 std::vector<int> sourceFace, std::vector<int> boundary) {
    auto piece = std::make_shared<Piece>();
    piece->name = name;
    piece->mesh.F = F;
    piece->table = buildEdgeTable(F, static_cast<int>(sourceVertex.size()));
    piece->mesh.V.resize(static_cast<Eigen::Index>(sourceVertex.size()), 3);
    for (std::size_t i = 0; i < sourceVertex.size(); ++i) {
        if (sourceVertex[i] >= 0) {
            piece->mesh.V.row(static_cast<Eigen::Index>(i)) =
                millimetresPer(file.unit) * file.soup->positions[sourceVertex[i]].transpose();
        }
    }
    piece->sourceVertex = std::move(sourceVertex);
    piece->sourceFace = std::move(sourceFace);
    piece->boundary = std::move(boundary);
    return piece;
}

std::shared_ptr<PieceResult> flatResult(std::shared_ptr<const Piece> piece) {
    auto result = std::make_shared<PieceResult>();
    FlatPiece flat;
    flat.Q = piece->mesh.V.leftCols(2);
    flat.boundaryIterations = 4;
    flat.closureGap = 1.5e-14;
    flat.angleEnergy = 0.25;
    flat.boundarySeconds = 0.001;
    flat.interiorSeconds = 0.002;
    PieceQuality quality;
    quality.area3d = 187.5;
    quality.piTheta = 0.125;
    quality.symmetricDirichlet = 1.0625;
    result->piece = std::move(piece);
    result->options.method = Method::Wang2005;
    result->flat = std::move(flat);
    result->quality = quality;
    result->seconds = 0.004;
    return result;
}

void addFace(PolygonSoup& soup, std::initializer_list<int> corners) {
    soup.corners.insert(soup.corners.end(), corners);
    soup.faceStart.push_back(static_cast<int>(soup.corners.size()));
}

void add(GarmentAndResults& all, const std::shared_ptr<const PieceResult>& result,
         const Eigen::Vector2d& offset) {
    all.garment.pieces.push_back(result->piece);
    all.results.push_back(result);
    all.marker.copies.push_back({static_cast<int>(all.results.size()) - 1, {offset}});
}

std::shared_ptr<SourceFile> textFile() {
    auto file = std::make_shared<SourceFile>();
    file->path = "made/by hand.obj";
    file->unit = LengthUnit::Centimetre;
    file->unitReason = "largest extent 10: read as centimetres";
    file->readSeconds = 0.5;
    const auto soup = std::make_shared<PolygonSoup>();
    file->soup = soup;
    const std::vector<std::pair<std::string, Eigen::Vector3d>> lines{
        {"0 0 0", {0, 0, 0}},
        {"1.50 0 -0", {1.5, 0, 0}},
        {"1.5 1.250 0", {1.5, 1.25, 0}},
        {"0 125e-2 0", {0, 1.25, 0}},
        {"3 0 0.000", {3, 0, 0}},
        {"3.0 1.25 0", {3, 1.25, 0}},
        {"0.75 2 0", {0.75, 2, 0}},
        {"9 9 9 0.5 0.5 0.5", {9, 9, 9}},
        {"10 9 9", {10, 9, 9}},
        {"10 \\\r\n 10 9", {10, 10, 9}},
        {"7 7 7 # unused", {7, 7, 7}}};
    std::string text;
    for (const auto& [line, position] : lines) {
        text += "v  ";
        soup->positionText.push_back({text.size(), static_cast<std::uint32_t>(line.size())});
        text += line + "\n";
        soup->positions.push_back(position);
    }
    soup->text = std::make_shared<const std::string>(std::move(text));
    addFace(*soup, {0, 1, 2, 3});  // front
    addFace(*soup, {7, 8, 9});     // ring
    addFace(*soup, {3, 2, 6});     // front
    addFace(*soup, {1, 4, 5, 2});  // back
    addFace(*soup, {0, 0, 1});     // in no piece
    soup->problems.push_back(
        {ErrorCode::OutputDiffers, Subject::file("by hand.obj"), "2 lines left out"});
    file->problems = soup->problems;
    file->problems.push_back(
        {ErrorCode::UnitGuessed, Subject::file("by hand.obj"), "read as centimetres"});
    file->problems.push_back(
        {ErrorCode::DegenerateFaceRecord, Subject::file("by hand.obj"), "1 face"});
    file->problems.push_back(soup->problems.front());  // said once more
    return file;
}

}  // namespace

Points2 rectangle(double x, double y, double width, double height) {
    Points2 points(4, 2);
    points << x, y, x + width, y, x + width, y + height, x, y + height;
    return points;
}

Points2 horseshoe(double x, double y, double size, double arm) {
    Points2 points(8, 2);
    points << 0, 0, size, 0, size, size, size - arm, size, size - arm, arm, arm, arm, arm, size, 0,
        size;
    points.rowwise() += Eigen::RowVector2d(x, y);
    return points;
}

Points2 curvedPanel(int count, double radius) {
    Points2 points(count, 2);
    for (int i = 0; i < count; ++i) {
        const double t = 2 * std::numbers::pi * (i + 0.3 * std::sin(7.0 * i)) / count;
        const double r = radius * (1 + 0.25 * std::cos(3 * t) + 0.003 * std::sin(40 * t));
        points.row(i) << r * std::cos(t) - 1.7 * radius, 0.8 * r * std::sin(t + 0.2) + 3 * radius;
    }
    return points;
}

Pattern sewingPattern() {
    Pattern pattern{"Größe <38> & \"Probe\"", {}};
    pattern.pieces.push_back({{}, "Ärmel <links> & \"rechts\"", "aermel", curvedPanel(300, 180)});
    pattern.pieces.push_back({{}, "前身頃", "piece", horseshoe(-1000, 4000, 300, 60)});
    pattern.pieces.push_back({{}, "neckband", "neckband", rectangle(12.34567, -55.5, 420.1, 22)});
    pattern.pieces.push_back({{}, "cuff 2", "cuff-2", curvedPanel(37, 61.234567)});
    return pattern;
}

Drawing sewingDrawing() {
    const Pattern pattern = sewingPattern();
    return draw(pattern, placeCopies(pattern));
}

Eigen::VectorXd edgeLengths(const Points2& outline) {
    Eigen::VectorXd lengths(outline.rows());
    for (Eigen::Index i = 0; i < outline.rows(); ++i) {
        lengths[i] = (outline.row((i + 1) % outline.rows()) - outline.row(i)).norm();
    }
    return lengths;
}

GarmentAndResults handmadeGarment() {
    const auto file = textFile();
    GarmentAndResults all;
    all.garment.files.push_back(file);

    Triangles two(2, 3), three(3, 3), one(1, 3);
    three << 0, 1, 2, 0, 2, 3, 3, 2, 4;
    const auto front =
        makePiece("front 1", *file, {0, 1, 2, 3, 6}, three, {0, 0, 2}, {0, 1, 2, 4, 3});
    add(all, flatResult(front), {100, 0.1});

    one << 0, 1, 2;
    const auto ring = makePiece("ring", *file, {7, 8, 9}, one, {1}, {});
    ring->defect = Error{ErrorCode::SeveralLoops, Subject::piece("ring"), "2 loops"};
    auto failed = std::make_shared<PieceResult>();
    failed->piece = ring;
    failed->error = ring->defect;
    add(all, failed, {0, 0});

    two << 0, 1, 2, 0, 2, 3;
    const auto back = makePiece("back", *file, {1, 4, 5, 2}, two, {3, 3}, {0, 1, 2, 3});
    auto natural = flatResult(back);
    natural->options.method = Method::Natural;
    natural->quality->symmetricDirichlet = std::nullopt;
    natural->quality->piE = std::numeric_limits<double>::quiet_NaN();
    natural->quality->strainMax = std::numeric_limits<double>::infinity();
    add(all, natural, {-15, 0});
    return all;
}

void addBinaryFile(GarmentAndResults& all) {
    auto file = std::make_shared<SourceFile>();
    file->path = "patch.ply";
    file->unit = LengthUnit::Inch;
    const double bad = std::numeric_limits<double>::quiet_NaN();
    const auto soup = std::make_shared<PolygonSoup>();
    file->soup = soup;
    soup->positions = {{0, 0, 0}, {0.1, 0, 0}, {0.1, 1, 0}, {bad, 2, 3}, {0, 1, 0}};
    addFace(*soup, {0, 1, 2, 4});
    const int index = static_cast<int>(all.garment.files.size());
    all.garment.files.push_back(file);

    Triangles F(4, 3);  // around a new vertex in the middle
    F << 0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4;
    const auto patch = makePiece("patch", *file, {0, 1, 2, 4, -1}, F, {0, 0, 0, 0}, {0, 1, 2, 3});
    patch->file = index;
    patch->mesh.V.row(4) << 1.27, 12.7, 0;
    add(all, flatResult(patch), {0, 0});
}

CommaLocale::CommaLocale() : before_(std::setlocale(LC_ALL, nullptr)) {
    std::locale::global(std::locale(std::locale::classic(), new CommaPunctuation));
    for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8"}) {  // where there is one
        if (std::setlocale(LC_ALL, name)) {
            break;
        }
    }
}

CommaLocale::~CommaLocale() {
    std::locale::global(std::locale::classic());
    std::setlocale(LC_ALL, before_.c_str());
}

}  // namespace toile::test
