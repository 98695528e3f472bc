// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linalg/frontal_cholesky.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <new>

#include "core/linalg/cholmod_workspace.h"
#include "core/linalg/front_tree.h"

// The functions of BLAS and LAPACK that we call ourselves. Matrices are stored by columns; call
// these within a `BlasCall`.
// NOLINTBEGIN(readability-identifier-naming): Fortran names them
extern "C" {
/// Lower Cholesky factor in place; info > 0: not positive definite.
void dpotrf_(const char* uplo, const int* n, double* a, const int* lda, int* info);
/// B := alpha B op(A)^-1 or alpha op(A)^-1 B.
void dtrsm_(const char* side, const char* uplo, const char* transa, const char* diag, const int* m,
            const int* n, const double* alpha, const double* a, const int* lda, double* b,
            const int* ldb);
/// C := alpha A A^T + beta C, one triangle of it.
void dsyrk_(const char* uplo, const char* trans, const int* n, const int* k, const double* alpha,
            const double* a, const int* lda, const double* beta, double* c, const int* ldc);
/// x := op(A)^-1 x.
void dtrsv_(const char* uplo, const char* trans, const char* diag, const int* n, const double* a,
            const int* lda, double* x, const int* incx);
/// y := alpha op(A) x + beta y.
void dgemv_(const char* trans, const int* m, const int* n, const double* alpha, const double* a,
            const int* lda, const double* x, const int* incx, const double* beta, double* y,
            const int* incy);
}
// NOLINTEND(readability-identifier-naming)

namespace toile::linalg {
namespace {

constexpr double kOne = 1, kMinusOne = -1, kNought = 0;
constexpr int kStep = 1;

/// Uninitialised numbers; null if there is no memory.
std::unique_ptr<double[]> unwritten(std::size_t count) {
    std::unique_ptr<double[]> numbers(new (std::nothrow) double[count]);
    useLargePages(numbers.get(), count);
    return numbers;
}

}  // namespace

struct FrontalCholesky::State {
    int threads = 1;
    FrontTree tree;
    std::unique_ptr<double[]> factor, work;

    double* columnsOf(const Front& front) { return factor.get() + front.start; }
    /// Position in the parent's rows of each row that a front passes on.
    const int* placesOf(const Front& front) const {
        return tree.placeInParent.data() + front.rowStart + front.columns;
    }

    bool eliminate(int s, const std::vector<double>& value);
    void takeUp(const Front& child, const Front& front, double* columns, double* rest,
                bool ofColumns) const;
    void forth(int s, Eigen::VectorXd& x, std::vector<double>& left);
    void back(int s, Eigen::VectorXd& x, std::vector<double>& left);
};

/// Adds a child's remainder to the columns that are eliminated or to the rest.
void FrontalCholesky::State::takeUp(const Front& child, const Front& front, double* columns,
                                    double* rest, bool ofColumns) const {
    const int* const place = placesOf(child);
    const int size = child.left();
    const auto split =
        static_cast<int>(std::lower_bound(place, place + size, front.columns) - place);
    const double* const from = work.get() + child.kept;
    const std::ptrdiff_t height = front.left();
    for (int j = ofColumns ? 0 : split; j < (ofColumns ? split : size); ++j) {
        const double* const column = from + static_cast<std::ptrdiff_t>(j) * size;
        double* const to = ofColumns ? columns + static_cast<std::ptrdiff_t>(place[j]) * front.rows
                                     : rest + (place[j] - front.columns) * height - front.columns;
        for (int i = j; i < size; ++i) {
            to[place[i]] += column[i];
        }
    }
}

/// @return whether it is positive definite
bool FrontalCholesky::State::eliminate(int s, const std::vector<double>& value) {
    const Front& front = tree.fronts[s];
    double* const columns = columnsOf(front);
    double* const rest = work.get() + front.kept;
    std::fill_n(columns, static_cast<std::ptrdiff_t>(front.columns) * front.rows, 0.0);
    for (const int entry : tree.entries[s]) {
        columns[tree.place[entry]] = value[entry];
    }
    for (const int child : tree.children[s]) {
        takeUp(tree.fronts[child], front, columns, rest, true);
    }
    int info = 0;
    dpotrf_("L", &front.columns, columns, &front.rows, &info);
    if (info != 0) {
        return false;
    }
    const int left = front.left();
    if (left == 0) {
        return true;
    }
    double* const below = columns + front.columns;
    dtrsm_("R", "L", "T", "N", &left, &front.columns, &kOne, columns, &front.rows, below,
           &front.rows);
    dsyrk_("L", "N", &left, &front.columns, &kMinusOne, below, &front.rows, &kNought, rest, &left);
    for (const int child : tree.children[s]) {
        takeUp(tree.fronts[child], front, columns, rest, false);
    }
    return true;
}

/// Solves with a front's columns.
/// @param x     by position in the order
/// @param left  per front, what it adds to the rows that it passes on
void FrontalCholesky::State::forth(int s, Eigen::VectorXd& x, std::vector<double>& left) {
    const Front& front = tree.fronts[s];
    double* const own = x.data() + front.first;
    double* const later = left.data() + front.rowStart + front.columns;
    std::fill_n(later, front.left(), 0.0);
    for (const int c : tree.children[s]) {
        const Front& child = tree.fronts[c];
        const int* const place = placesOf(child);
        const double* const from = left.data() + child.rowStart + child.columns;
        for (int i = 0; i < child.left(); ++i) {
            (place[i] < front.columns ? own[place[i]] : later[place[i] - front.columns]) += from[i];
        }
    }
    dtrsv_("L", "N", "N", &front.columns, columnsOf(front), &front.rows, own, &kStep);
    const int count = front.left();
    if (count > 0) {
        dgemv_("N", &count, &front.columns, &kMinusOne, columnsOf(front) + front.columns,
               &front.rows, own, &kStep, &kOne, later, &kStep);
    }
}

/// Solves with a front's rows.
/// @param left  from `forth`; overwritten
void FrontalCholesky::State::back(int s, Eigen::VectorXd& x, std::vector<double>& left) {
    const Front& front = tree.fronts[s];
    double* const own = x.data() + front.first;
    const int count = front.left();
    if (count > 0) {
        const int* const row = tree.row.data() + front.rowStart + front.columns;
        double* const later = left.data() + front.rowStart + front.columns;
        std::transform(row, row + count, later, [&x](int place) { return x[place]; });
        dgemv_("T", &count, &front.columns, &kMinusOne, columnsOf(front) + front.columns,
               &front.rows, later, &kStep, &kOne, own, &kStep);
    }
    dtrsv_("L", "T", "N", &front.columns, columnsOf(front), &front.rows, own, &kStep);
}

FrontalCholesky::FrontalCholesky(int threads) : state_(std::make_unique<State>()) {
    state_->threads = threads;
}

FrontalCholesky::~FrontalCholesky() = default;
FrontalCholesky::FrontalCholesky(FrontalCholesky&&) noexcept = default;
FrontalCholesky& FrontalCholesky::operator=(FrontalCholesky&&) noexcept = default;

Result<void> FrontalCholesky::analyse(const SymmetricMatrix& pattern,
                                      const std::vector<int>& order) {
    auto tree = frontTree(pattern, order);
    if (!tree) {
        return tree.error();
    }
    state_->tree = std::move(tree).value();
    state_->factor = unwritten(state_->tree.factorSize);
    state_->work = unwritten(state_->tree.workSize);
    if (!state_->factor || !state_->work) {
        return Error{ErrorCode::OutOfMemory, {}, "factorising"};
    }
    return {};
}

Result<void> FrontalCholesky::refactorise(const SymmetricMatrix& matrix) {
    assert(state_->factor && matrix.value.size() == state_->tree.place.size());
    const FrontTree& tree = state_->tree;
    const FrontsDone done = doFronts(tree, FrontSense::Upwards, state_->threads, [&](int t) {
        for (int s = tree.tasks[t].first; s <= tree.tasks[t].last; ++s) {
            if (!state_->eliminate(s, matrix.value)) {
                return false;
            }
        }
        return true;
    });
    if (done == FrontsDone::Refused) {
        return Error{ErrorCode::FactorisationFailed, {}, "the matrix is not positive definite"};
    }
    if (done == FrontsDone::NoRoom) {
        return Error{ErrorCode::OutOfMemory, {}, "factorising"};
    }
    return {};
}

Result<Eigen::VectorXd> FrontalCholesky::solve(const Eigen::VectorXd& right) {
    const FrontTree& tree = state_->tree;
    const Eigen::Map<const Eigen::VectorXi> order(tree.order.data(),
                                                  static_cast<Eigen::Index>(tree.order.size()));
    Eigen::VectorXd x = right(order);
    std::vector<double> left(tree.row.size());
    const auto forth = [&](int t) {
        for (int s = tree.tasks[t].first; s <= tree.tasks[t].last; ++s) {
            state_->forth(s, x, left);
        }
        return true;
    };
    const auto back = [&](int t) {
        for (int s = tree.tasks[t].last; s >= tree.tasks[t].first; --s) {
            state_->back(s, x, left);
        }
        return true;
    };
    for (const auto& [sense, work] :
         {std::pair<FrontSense, std::function<bool(int)>>{FrontSense::Upwards, forth},
          {FrontSense::Downwards, back}}) {
        if (doFronts(tree, sense, state_->threads, work) == FrontsDone::NoRoom) {
            return Error{ErrorCode::OutOfMemory, {}, "back-substitution"};
        }
    }
    Eigen::VectorXd solution(x.size());
    solution(order) = x;
    return solution;
}

}  // namespace toile::linalg
