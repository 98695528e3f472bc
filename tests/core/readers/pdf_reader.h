// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Geometry>

#include "core/base/result.h"
#include "core/formats/read_back.h"

namespace toile {

/// The drawing as a page of a file shows it.
struct ReadPdfView {
    Eigen::Matrix<double, 2, 3> matrix;  ///< from the drawing, mm, to the page, points
    Eigen::AlignedBox2d clip;            ///< on the page, points
};

struct ReadPdfPage {
    Eigen::Vector2d size;  ///< points
    std::vector<ReadPdfView> views{};
    std::vector<ReadLine> lines{};  ///< with an id, that are the page's own: on it, points
};

struct ReadPdf {
    std::vector<ReadPdfPage> pages{};
    ReadDrawing drawing{};  ///< mm
    std::vector<std::string> layers{}, hiddenLayers{};
};

/// Reads our own PDF files again by code that the writer does not share: pages, layers, and every
/// line that has an id, curves by points that are within 0.001 of them.
/// Takes any bytes. Errors: MalformedFile. Cost: linear.
Result<ReadPdf> readPdf(std::string_view bytes);

}  // namespace toile
