// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/flow/cell_forms_of_degree.h>

namespace semilunar::flow
{
  template <int dim>
  std::unique_ptr<CellForms<dim>> CellForms<dim>::create(const Spaces<dim> &spaces,
                                                         const Parameters &parameters)
  {
    switch (spaces.degree())
    {
    case 2:
      return std::make_unique<CellFormsOfDegree<dim, 2>>(spaces, parameters);
    case 3:
      return std::make_unique<CellFormsOfDegree<dim, 3>>(spaces, parameters);
    default:
      throw InputError("Flow/Degree", std::to_string(spaces.degree()), "no such element",
                       "allowed: 2, 3");
    }
  }

  template class CellForms<2>;
  template class CellForms<3>;
} // namespace semilunar::flow
