// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <atomic>
#include <new>
#include <numeric>
#include <system_error>
#include <thread>

#include "core/base/stopwatch.h"
#include "core/pipeline/pipeline.h"

namespace toile {
namespace {

std::shared_ptr<const PieceResult> flattenOne(const std::shared_ptr<const Piece>& piece,
                                              const FlattenOptions& options, Progress& progress) {
    const Stopwatch time;
    auto result = std::make_shared<PieceResult>();
    result->piece = piece;
    result->options = options;
    try {
        auto flat = flatten(*piece, options, progress);
        if (flat) {
            result->quality = measure(*piece, flat->Q);
            result->flat = std::move(*flat);
        } else {
            result->error = flat.error();
        }
    } catch (const std::bad_alloc&) {  // one piece too large must not end the others' thread
        result->flat.reset();
        result->quality.reset();
        result->error = Error{ErrorCode::OutOfMemory, piece->name, ""};
    }
    result->seconds = time.seconds();
    return result;
}

}  // namespace

PieceResults flattenGarment(const Garment& garment, const FlattenOptions& options,
                            Progress& progress) {
    const auto size = [&](std::size_t k) {
        return static_cast<double>(garment.pieces[k]->mesh.F.rows());
    };
    // Largest first, so that no thread is left alone with a big piece at the end. Each result goes
    // to its own place: the order of work leaves no trace.
    std::vector<std::size_t> order(garment.pieces.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return size(a) > size(b); });
    double total = 0;
    for (const std::size_t k : order) {
        total += size(k);
    }
    progress.start(total);

    PieceResults results(garment.pieces.size());
    std::atomic<std::size_t> next{0};
    const auto work = [&] {
        for (std::size_t k = next++; k < order.size(); k = next++) {
            results[order[k]] = flattenOne(garment.pieces[order[k]], options, progress);
            progress.advance(size(order[k]));
        }
    };
    const std::size_t helpers =
        std::min<std::size_t>(std::max(1U, std::thread::hardware_concurrency()), order.size());
    std::vector<std::thread> threads;
    try {
        for (std::size_t t = 1; t < helpers; ++t) {
            threads.emplace_back(work);
        }
    } catch (const std::system_error&) {
        // No more threads to be had: those there are, and this one, do the work.
    }
    work();
    for (std::thread& thread : threads) {
        thread.join();
    }
    return results;
}

}  // namespace toile
