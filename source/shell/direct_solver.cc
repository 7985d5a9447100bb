// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/shell/direct_solver.h>

#include <umfpack.h>

#include <algorithm>
#include <array>
#include <limits>

namespace semilunar::shell
{
  namespace
  {
    using Control = std::array<double, UMFPACK_CONTROL>;

    Control control()
    {
      Control settings;
      umfpack_di_defaults(settings.data());
      settings[UMFPACK_IRSTEP] = 0; // no iterative refinement
      return settings;
    }

    [[noreturn]] void give_up()
    {
      throw NumericsError("the tangent matrix is singular or not finite", "its factorisation", "");
    }
  } // namespace

  void DirectSolver::analyse(const dealii::SparsityPattern &sparsity)
  {
    symbolic.reset();
    numeric.reset();
    AssertThrow(sparsity.n_nonzero_elements() <
                    static_cast<std::size_t>(std::numeric_limits<int>::max()),
                dealii::ExcMessage("the tangent matrix has too many entries"));
    starts.assign(1, 0);
    columns.clear();
    places.resize(sparsity.n_nonzero_elements());
    values.resize(sparsity.n_nonzero_elements());
    std::vector<std::pair<int, std::size_t>> row; // columns and where the matrix has them
    std::size_t source = 0;
    for (unsigned int i = 0; i < sparsity.n_rows(); ++i)
    {
      row.clear();
      for (auto entry = sparsity.begin(i); entry != sparsity.end(i); ++entry)
        row.emplace_back(entry->column(), source++);
      std::sort(row.begin(), row.end());
      for (const auto &[column, origin] : row)
      {
        places[origin] = columns.size();
        columns.push_back(column);
      }
      starts.push_back(columns.size());
    }
  }

  void DirectSolver::factorize(const dealii::SparseMatrix<double> &matrix)
  {
    auto place = places.begin();
    for (const auto &entry : matrix)
      values[*place++] = entry.value();

    const Control settings = control();
    void *object = nullptr;
    if (!symbolic)
    {
      const int n = starts.size() - 1;
      // The values tell UMFPACK which pivots to prefer; those of the first matrix do for all.
      if (umfpack_di_symbolic(n, n, starts.data(), columns.data(), values.data(), &object,
                              settings.data(), nullptr) != UMFPACK_OK)
        give_up();
      symbolic = Object(object, {umfpack_di_free_symbolic});
    }
    numeric.reset();
    const int status = umfpack_di_numeric(starts.data(), columns.data(), values.data(),
                                          symbolic.get(), &object, settings.data(), nullptr);
    numeric = Object(object, {umfpack_di_free_numeric});
    if (status != UMFPACK_OK)
      give_up();
  }

  void DirectSolver::solve(dealii::Vector<double> &b) const
  {
    Assert(numeric, dealii::ExcMessage("factorize() first"));
    const dealii::Vector<double> right_hand_side = b;
    const Control settings = control();
    // UMFPACK reads our rows as columns: it holds the transposed matrix.
    const int status =
        umfpack_di_solve(UMFPACK_At, starts.data(), columns.data(), values.data(), b.begin(),
                         right_hand_side.begin(), numeric.get(), settings.data(), nullptr);
    if (status != UMFPACK_OK)
      give_up();
  }
} // namespace semilunar::shell
