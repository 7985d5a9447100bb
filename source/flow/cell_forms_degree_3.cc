// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/flow/cell_forms_of_degree.templates.h>
#include <semilunar/flow/cell_matrices.templates.h>

namespace semilunar::flow
{
  template class CellFormsOfDegree<2, 3>;
  template class CellFormsOfDegree<3, 3>;
} // namespace semilunar::flow
