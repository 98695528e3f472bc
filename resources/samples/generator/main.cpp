// SPDX-License-Identifier: GPL-3.0-or-later
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "garments.h"
#include "obj_writer.h"
#include "shapes.h"

namespace {

bool writeGarment(const toile::samples::Garment& garment, const std::filesystem::path& folder) {
    const std::string fileName = garment.name + ".obj";
    std::ofstream file(folder / fileName, std::ios::binary);
    file << toile::samples::writeObj(garment);
    file.close();
    if (!file) {
        std::cerr << "Could not write " << (folder / fileName).string() << "\n";
        return false;
    }
    std::size_t vertices = 0;
    std::size_t triangles = 0;
    for (const auto& piece : garment.pieces) {
        vertices += piece.vertices.size();
        triangles += piece.triangles.size();
    }
    std::cout << fileName << ": " << garment.pieces.size() << " pieces, " << vertices
              << " vertices, " << triangles << " triangles\n";
    return true;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::cerr
            << "Usage: toile_make_samples OUTDIR\n"
               "Writes Toile's sample garments as OBJ files into OUTDIR, and shapes that are no\n"
               "garments into OUTDIR/shapes.\n";
        return 2;
    }
    try {
        const std::filesystem::path folder = argv[1];
        std::filesystem::create_directories(folder);
        bool written = true;
        for (const auto make :
             {toile::samples::makeTshirt, toile::samples::makeBodice, toile::samples::makeTrousers,
              toile::samples::makeCap, toile::samples::makeSkirt}) {
            written = writeGarment(make(), folder) && written;
        }
        const std::filesystem::path shapes = folder / "shapes";
        std::filesystem::create_directories(shapes);
        written = writeGarment(toile::samples::makeCubeOpenedAlongH(), shapes) && written;
        return written ? 0 : 1;
    } catch (const std::exception& error) {
        std::cerr << "toile_make_samples: " << error.what() << "\n";
        return 1;
    }
}
