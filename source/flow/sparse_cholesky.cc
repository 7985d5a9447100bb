// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/flow/sparse_cholesky.h>

#include <cholmod.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace semilunar::flow
{
  namespace
  {
    /// y += A x for m rows and n columns of a matrix stored column by column.
    template <class Number>
    void add_product(const Number *A, const unsigned int stride, const unsigned int m,
                     const unsigned int n, const Number *x, Number *__restrict y)
    {
      unsigned int j = 0;
      for (; j + 4 <= n; j += 4, A += 4 * std::size_t(stride))
      {
        const Number *A1 = A + stride, *A2 = A1 + stride, *A3 = A2 + stride;
        const Number x0 = x[j], x1 = x[j + 1], x2 = x[j + 2], x3 = x[j + 3];
        for (unsigned int i = 0; i < m; ++i)
          y[i] += A[i] * x0 + A1[i] * x1 + A2[i] * x2 + A3[i] * x3;
      }
      for (; j < n; ++j, A += stride)
        for (unsigned int i = 0; i < m; ++i)
          y[i] += A[i] * x[j];
    }

    /// Subtract from y the product of the transposed matrix with x: n_columns scalar products of m
    /// entries at once, summed up in parts that fill registers.
    template <unsigned int n_columns, class Number>
    void subtract_columns(const Number *A, const unsigned int stride, const unsigned int m,
                          const Number *x, Number *y)
    {
      constexpr unsigned int width = 16;
      Number parts[n_columns][width] = {};
      unsigned int i = 0;
      for (; i + width <= m; i += width)
        for (unsigned int j = 0; j < n_columns; ++j)
          for (unsigned int k = 0; k < width; ++k)
            parts[j][k] += A[std::size_t(j) * stride + i + k] * x[i + k];
      for (unsigned int k = 0; i + k < m; ++k)
        for (unsigned int j = 0; j < n_columns; ++j)
          parts[j][k] += A[std::size_t(j) * stride + i + k] * x[i + k];
      for (unsigned int j = 0; j < n_columns; ++j)
      {
        for (unsigned int half = width / 2; half > 0; half /= 2)
          for (unsigned int k = 0; k < half; ++k)
            parts[j][k] += parts[j][k + half];
        y[j] -= parts[j][0];
      }
    }

    /// y -= A^T x for m rows and n columns of a matrix stored column by column.
    template <class Number>
    void subtract_transposed_product(const Number *A, const unsigned int stride,
                                     const unsigned int m, const unsigned int n, const Number *x,
                                     Number *y)
    {
      unsigned int j = 0;
      for (; j + 4 <= n; j += 4, A += 4 * std::size_t(stride))
        subtract_columns<4>(A, stride, m, x, y + j);
      for (; j < n; ++j, A += stride)
        subtract_columns<1>(A, stride, m, x, y + j);
    }
  } // namespace

  template <class Number>
  struct SparseCholesky<Number>::Cholmod
  {
    Cholmod()
    {
      cholmod_start(&common);
      common.supernodal = CHOLMOD_SUPERNODAL;
      common.print = 0; // no messages of its own
    }
    ~Cholmod()
    {
      cholmod_free_factor(&factor, &common);
      cholmod_finish(&common);
    }

    cholmod_common common;
    cholmod_factor *factor = nullptr;
  };

  template <class Number>
  SparseCholesky<Number>::SparseCholesky() = default;

  template <class Number>
  SparseCholesky<Number>::~SparseCholesky() = default;

  template <class Number>
  void SparseCholesky<Number>::clear()
  {
    cholmod.reset();
  }

  template <class Number>
  void SparseCholesky<Number>::factorise(Columns &matrix)
  {
    const std::size_t n = matrix.start.size() - 1;
    cholmod_sparse A = {};
    A.nrow = A.ncol = n;
    A.nzmax = matrix.row.size();
    A.p = matrix.start.data();
    A.i = matrix.row.data();
    A.x = matrix.value.data();
    A.stype = -1; // the lower triangle
    A.itype = CHOLMOD_INT;
    A.xtype = CHOLMOD_REAL;
    A.dtype = CHOLMOD_DOUBLE;
    A.sorted = A.packed = 1;
    double mean = 0.;
    for (std::size_t i = 0; i < n; ++i)
      mean += matrix.value[matrix.start[i]] / n;
    // BLAS may take pivots that are no numbers.
    const bool finite =
        std::isfinite(std::accumulate(matrix.value.begin(), matrix.value.end(), 0.));
    if (!cholmod)
      cholmod = std::make_unique<Cholmod>();
    cholmod_common *common = &cholmod->common;
    if (!cholmod->factor)
      cholmod->factor = cholmod_analyze(&A, common);
    bool done = false;
    for (double share = 0.; cholmod->factor && !done && share < 1.;
         share = std::max(1e-3, 10. * share))
    {
      double shift[2] = {share * mean, 0.};
      done = finite && cholmod_factorize_p(&A, shift, nullptr, 0, cholmod->factor, common) != 0 &&
             common->status == CHOLMOD_OK;
    }
    if (!done)
    {
      clear();
      throw NumericsError("the matrix of the wall cannot be factorised", "", "");
    }
    keep_factors();
    // Only the pattern is needed for the next matrix.
    cholmod_change_factor(CHOLMOD_PATTERN, 1, 1, 1, 1, cholmod->factor, common);
  }

  template <class Number>
  void SparseCholesky<Number>::keep_factors()
  {
    const cholmod_factor &L = *cholmod->factor;
    const auto copy = [](auto &to, const void *from, const std::size_t n)
    {
      const int *begin = static_cast<const int *>(from);
      to.assign(begin, begin + n);
    };
    copy(permutation, L.Perm, L.n);
    copy(first_column, L.super, L.nsuper + 1);
    copy(row_start, L.pi, L.nsuper + 1);
    copy(value_start, L.px, L.nsuper + 1);
    copy(row, L.s, L.ssize);
    const double *begin = static_cast<const double *>(L.x);
    value.assign(begin, begin + L.xsize);
    unsigned int longest = 0;
    for (unsigned int s = 0; s + 1 < first_column.size(); ++s)
    {
      const unsigned int n_rows = row_start[s + 1] - row_start[s],
                         n = first_column[s + 1] - first_column[s];
      longest = std::max(longest, n_rows);
      for (unsigned int j = 0; j < n; ++j)
      {
        Number &diagonal = value[value_start[s] + j * std::size_t(n_rows + 1)];
        diagonal = Number(1.) / diagonal;
      }
    }
    work.resize(L.n);
    rows_below.resize(longest);
  }

  template <class Number>
  void SparseCholesky<Number>::solve(const double *b, double *x) const
  {
    const unsigned int n_supernodes = first_column.size() - 1;
    for (unsigned int i = 0; i < work.size(); ++i)
      work[i] = b[permutation[i]];
    for (unsigned int s = 0; s < n_supernodes; ++s)
    {
      const unsigned int stride = row_start[s + 1] - row_start[s],
                         n = first_column[s + 1] - first_column[s], n_below = stride - n;
      const Number *L = value.data() + value_start[s];
      Number *y = work.data() + first_column[s];
      for (unsigned int j = 0; j < n; ++j)
      {
        const Number *column = L + std::size_t(j) * stride;
        y[j] *= column[j];
        for (unsigned int i = j + 1; i < n; ++i)
          y[i] -= column[i] * y[j];
      }
      std::fill_n(rows_below.begin(), n_below, Number(0.));
      add_product(L + n, stride, n_below, n, y, rows_below.data());
      const int *below = row.data() + row_start[s] + n;
      for (unsigned int i = 0; i < n_below; ++i)
        work[below[i]] -= rows_below[i];
    }
    for (unsigned int s = n_supernodes; s-- > 0;)
    {
      const unsigned int stride = row_start[s + 1] - row_start[s],
                         n = first_column[s + 1] - first_column[s], n_below = stride - n;
      const Number *L = value.data() + value_start[s];
      Number *y = work.data() + first_column[s];
      const int *below = row.data() + row_start[s] + n;
      for (unsigned int i = 0; i < n_below; ++i)
        rows_below[i] = work[below[i]];
      subtract_transposed_product(L + n, stride, n_below, n, rows_below.data(), y);
      for (unsigned int j = n; j-- > 0;)
      {
        const Number *column = L + std::size_t(j) * stride;
        subtract_columns<1>(column + j + 1, stride, n - j - 1, y + j + 1, y + j);
        y[j] *= column[j];
      }
    }
    for (unsigned int i = 0; i < work.size(); ++i)
      x[permutation[i]] = work[i];
  }

  template class SparseCholesky<float>;
  template class SparseCholesky<double>;
} // namespace semilunar::flow
