// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/flow/ilu.h>

#include <algorithm>

namespace semilunar::flow
{
  template <int n_components>
  void CompressedRows::vmult(const double *x, double *y) const
  {
    for (unsigned int i = 0; i < n_rows(); ++i)
    {
      double sum[n_components] = {};
      for (unsigned int k = row_start[i]; k < row_start[i + 1]; ++k)
        for (int c = 0; c < n_components; ++c)
          sum[c] += value[k] * x[n_components * column[k] + c];
      for (int c = 0; c < n_components; ++c)
        y[n_components * i + c] = sum[c];
    }
  }

  void Ilu::factorise(const CompressedRows &matrix)
  {
    const unsigned int n = matrix.n_rows();
    row_start = matrix.row_start;
    column = matrix.column;
    value = matrix.value;
    diagonal.resize(n);
    work.resize(n);

    constexpr unsigned int absent = -1;
    std::vector<unsigned int> place(n, absent); // of each column in the current row
    for (unsigned int i = 0; i < n; ++i)
    {
      for (unsigned int k = row_start[i]; k < row_start[i + 1]; ++k)
        place[column[k]] = k;
      unsigned int k = row_start[i];
      for (; column[k] < i; ++k)
      {
        const unsigned int row = column[k];
        const float factor = value[k] *= value[diagonal[row]];
        if (factor != 0.f)
          for (unsigned int u = diagonal[row] + 1; u < row_start[row + 1]; ++u)
            if (place[column[u]] != absent)
              value[place[column[u]]] -= factor * value[u];
      }
      diagonal[i] = k;
      if (!(value[k] > 0.f))
        throw NumericsError("the incomplete factorisation of the momentum matrix has a pivot that "
                            "is not positive",
                            "", "");
      value[k] = 1.f / value[k];
      for (k = row_start[i]; k < row_start[i + 1]; ++k)
        place[column[k]] = absent;
    }
  }

  template <int n_components>
  void Ilu::solve(const double *b, double *x) const
  {
    const unsigned int n = diagonal.size();
    // Sums in pairs: a single one would wait for itself.
    const auto row_sum = [this](const unsigned int begin, const unsigned int end)
    {
      Four even = Four{}, odd = Four{};
      unsigned int k = begin;
      for (; k + 1 < end; k += 2)
      {
        even += value[k] * work[column[k]];
        odd += value[k + 1] * work[column[k + 1]];
      }
      if (k < end)
        even += value[k] * work[column[k]];
      return even + odd;
    };
    for (unsigned int i = 0; i < n; ++i)
    {
      Four right = Four{};
      for (int c = 0; c < n_components; ++c)
        right[c] = b[n_components * i + c];
      work[i] = right - row_sum(row_start[i], diagonal[i]);
    }
    for (unsigned int i = n; i-- > 0;)
    {
      work[i] = (work[i] - row_sum(diagonal[i] + 1, row_start[i + 1])) * value[diagonal[i]];
      for (int c = 0; c < n_components; ++c)
        x[n_components * i + c] = work[i][c];
    }
  }

  template void CompressedRows::vmult<2>(const double *, double *) const;
  template void CompressedRows::vmult<3>(const double *, double *) const;
  template void Ilu::solve<1>(const double *, double *) const;
  template void Ilu::solve<2>(const double *, double *) const;
  template void Ilu::solve<3>(const double *, double *) const;
} // namespace semilunar::flow
