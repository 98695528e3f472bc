// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linalg/sparse_cholesky.h"

#include <cassert>
#include <mutex>

#include <cholmod.h>
#include <omp.h>
#ifdef __linux__
#include <sys/mman.h>
#endif

// Present where OpenBLAS stands in for the BLAS; declared weak because it need not.
#ifdef __ELF__
// NOLINTNEXTLINE(readability-identifier-naming): OpenBLAS names it
extern "C" void openblas_set_num_threads(int count) __attribute__((weak));
#else
static void (*const openblas_set_num_threads)(int) = nullptr;
#endif

namespace toile::linalg {

SymmetricMatrix SymmetricBuilder::build() const {
    Eigen::SparseMatrix<double> sum(size_, size_);
    sum.setFromTriplets(entries_.begin(), entries_.end());
    const int* const start = sum.outerIndexPtr();
    const int* const row = sum.innerIndexPtr();
    const double* const value = sum.valuePtr();
    return {size_,
            {start, start + size_ + 1},
            {row, row + sum.nonZeros()},
            {value, value + sum.nonZeros()}};
}

namespace {

/// Pieces are solved side by side already, and the same input gives the same bits. Thread-safe.
void useOneBlasThread() {
    if (openblas_set_num_threads != nullptr) {
        openblas_set_num_threads(1);
    }
}

/// While it lives the thread may call the BLAS, if there is room. OpenBLAS takes a working buffer
/// for each thread that calls it at a time, keeps it for later, and where the process may have no
/// more memory (`ulimit -v`) it tries again for ever.
class BlasCall {
public:
    BlasCall() {
        const std::lock_guard lock(mutex_);
        if (++calling_ > withRoom_ && hasRoomFor(calling_)) {
            withRoom_ = calling_;
        }
        hasRoom_ = calling_ <= withRoom_;
    }
    ~BlasCall() {
        const std::lock_guard lock(mutex_);
        --calling_;
    }
    BlasCall(const BlasCall&) = delete;
    BlasCall& operator=(const BlasCall&) = delete;

    bool hasRoom() const { return hasRoom_; }

private:
    static constexpr std::size_t kBuffer = std::size_t{128} << 20U;  ///< OpenBLAS's, on x86-64
    static constexpr std::size_t kBeside = std::size_t{16} << 20U;   ///< for all else meanwhile

    /// Touches no memory.
    static bool hasRoomFor(int calling) {
#ifdef __linux__
        const std::size_t size = static_cast<std::size_t>(calling) * kBuffer + kBeside;
        void* const room =
            mmap(nullptr, size, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
        return room != MAP_FAILED && munmap(room, size) == 0;
#else
        return calling > 0;
#endif
    }

    static inline std::mutex mutex_;
    static inline int calling_ = 0;   ///< now
    static inline int withRoom_ = 0;  ///< as many at a time have their buffers
    bool hasRoom_ = false;
};

/// Asks for large pages under the numbers of a factor: that the system hands out small ones, each
/// cleared first, is a tenth of the time of a factorisation.
void useLargePages(const cholmod_factor& factor) {
#ifdef __linux__
    constexpr std::size_t kPage = std::size_t{2} << 20U;
    void* first = factor.x;
    std::size_t bytes = sizeof(double) * factor.xsize;
    if (first && std::align(kPage, kPage, first, bytes)) {
        madvise(first, bytes / kPage * kPage, MADV_HUGEPAGE);
    }
#else
    static_cast<void>(factor);
#endif
}

/// CHOLMOD's view of our arrays; it reads them and keeps nothing.
cholmod_sparse viewOf(const SymmetricMatrix& matrix) {
    cholmod_sparse view{};
    view.nrow = view.ncol = static_cast<std::size_t>(matrix.size);
    view.nzmax = matrix.row.size();
    view.p = const_cast<int*>(matrix.columnStart.data());
    view.i = const_cast<int*>(matrix.row.data());
    view.x = const_cast<double*>(matrix.value.data());
    view.stype = -1;  // lower triangle stored
    view.itype = CHOLMOD_INT;
    view.xtype = matrix.value.empty() ? CHOLMOD_PATTERN : CHOLMOD_REAL;
    view.dtype = CHOLMOD_DOUBLE;
    view.sorted = 1;
    view.packed = 1;
    return view;
}

}  // namespace

/// CHOLMOD's settings and working memory, for one thread at a time.
struct CholmodWorkspace {
    cholmod_common common{};

    CholmodWorkspace() {
        // CHOLMOD opens four OpenMP threads per large supernode, whatever the machine has. Pieces
        // are solved side by side already: no parallel regions, on the calling thread.
        omp_set_max_active_levels(0);
        useOneBlasThread();
        cholmod_start(&common);
        common.print = 0;  // errors are values here, not text on a terminal
        common.error_handler = nullptr;
        // Minimum degree, or an order that is given: CHOLMOD would otherwise try METIS above a fill
        // threshold, which never pays for a few solves (the floor's table in docs/performance.md).
        common.nmethods = 1;
        common.method[0].ordering = CHOLMOD_AMD;
        common.postorder = 1;
        // Larger blocks than by default, with more zeros in them: a tenth less time on meshes of
        // 45 000 to a million triangles.
        common.supernodal = CHOLMOD_AUTO;
        common.nrelax[0] = 8;
        common.nrelax[1] = 24;
        common.nrelax[2] = 64;
        common.zrelax[0] = 0.8;
        common.zrelax[1] = 0.2;
        common.zrelax[2] = 0.1;
        common.final_ll = 1;  // L L^T: an indefinite matrix is refused, not factorised
    }
    ~CholmodWorkspace() { cholmod_finish(&common); }
    CholmodWorkspace(const CholmodWorkspace&) = delete;
    CholmodWorkspace& operator=(const CholmodWorkspace&) = delete;
};

struct SparseCholesky::State {
    CholmodWorkspace workspace;
    cholmod_factor* factor = nullptr;

    State() = default;
    ~State() { cholmod_free_factor(&factor, &workspace.common); }
    State(const State&) = delete;
    State& operator=(const State&) = delete;
};

SparseCholesky::SparseCholesky() : state_(std::make_unique<State>()) {}

SparseCholesky::~SparseCholesky() = default;
SparseCholesky::SparseCholesky(SparseCholesky&&) noexcept = default;
SparseCholesky& SparseCholesky::operator=(SparseCholesky&&) noexcept = default;

Result<void> SparseCholesky::factorise(const SymmetricMatrix& matrix) {
    if (auto analysed = analyse(matrix); !analysed) {
        return analysed;
    }
    return refactorise(matrix);
}

Result<void> SparseCholesky::analyse(const SymmetricMatrix& pattern, std::vector<int> order) {
    cholmod_common& common = state_->workspace.common;
    cholmod_free_factor(&state_->factor, &common);
    cholmod_sparse view = viewOf(pattern);
    common.method[0].ordering = order.empty() ? CHOLMOD_AMD : CHOLMOD_GIVEN;
    state_->factor =
        cholmod_analyze_p(&view, order.empty() ? nullptr : order.data(), nullptr, 0, &common);
    if (state_->factor == nullptr) {
        return Error{ErrorCode::OutOfMemory, {}, "ordering"};
    }
    return {};
}

Result<void> SparseCholesky::refactorise(const SymmetricMatrix& matrix) {
    assert(state_->factor != nullptr);
    cholmod_common& common = state_->workspace.common;
    const BlasCall blas;
    if (state_->factor->is_super != 0 && !blas.hasRoom()) {
        return Error{ErrorCode::OutOfMemory, {}, "factorising"};
    }
    if (state_->factor->is_super != 0 && state_->factor->xtype == CHOLMOD_PATTERN) {
        cholmod_change_factor(CHOLMOD_REAL, 1, 1, 1, 1, state_->factor, &common);
        useLargePages(*state_->factor);
    }
    cholmod_sparse view = viewOf(matrix);
    cholmod_factorize(&view, state_->factor, &common);
    if (common.status == CHOLMOD_NOT_POSDEF || state_->factor->minor < state_->factor->n) {
        return Error{ErrorCode::FactorisationFailed, {}, "the matrix is not positive definite"};
    }
    if (common.status < CHOLMOD_OK) {
        return Error{ErrorCode::OutOfMemory, {}, "factorising"};
    }
    return {};
}

Result<Eigen::MatrixXd> SparseCholesky::solve(const Eigen::MatrixXd& B) const {
    assert(state_->factor != nullptr);
    const BlasCall blas;
    if (state_->factor->is_super != 0 && !blas.hasRoom()) {
        return Error{ErrorCode::OutOfMemory, {}, "back-substitution"};
    }
    CholmodWorkspace workspace;  // its own: several threads may solve at a time
    cholmod_dense right{};
    right.nrow = static_cast<std::size_t>(B.rows());
    right.ncol = static_cast<std::size_t>(B.cols());
    right.nzmax = right.nrow * right.ncol;
    right.d = right.nrow;
    right.x = const_cast<double*>(B.data());
    right.xtype = CHOLMOD_REAL;
    right.dtype = CHOLMOD_DOUBLE;
    cholmod_dense* x = cholmod_solve(CHOLMOD_A, state_->factor, &right, &workspace.common);
    if (x == nullptr) {
        return Error{ErrorCode::OutOfMemory, {}, "back-substitution"};
    }
    Eigen::MatrixXd X =
        Eigen::Map<const Eigen::MatrixXd>(static_cast<const double*>(x->x), B.rows(), B.cols());
    cholmod_free_dense(&x, &workspace.common);
    return X;
}

std::size_t SparseCholesky::bytes() const {
    const cholmod_factor* factor = state_->factor;
    if (factor == nullptr) {
        return 0;
    }
    const std::size_t entries = factor->is_super != 0
                                    ? sizeof(double) * factor->xsize + sizeof(int) * factor->ssize
                                    : (sizeof(double) + sizeof(int)) * factor->nzmax;
    return entries + 4 * sizeof(int) * factor->n;
}

}  // namespace toile::linalg
