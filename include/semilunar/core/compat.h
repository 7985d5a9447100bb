// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_core_compat_h
#define semilunar_core_compat_h

#include <deal.II/base/config.h>
#include <deal.II/base/data_out_base.h>

namespace semilunar
{
  /// Flags of VTU files that are compressed as fast as zlib can.
  inline dealii::DataOutBase::VtkFlags fast_vtk_flags(const double time, const bool high_order)
  {
    dealii::DataOutBase::VtkFlags flags;
    flags.time = time;
    flags.write_higher_order_cells = high_order;
#if DEAL_II_VERSION_GTE(9, 5, 0)
    flags.compression_level = dealii::DataOutBase::CompressionLevel::best_speed;
#else
    flags.compression_level = dealii::DataOutBase::VtkFlags::best_speed;
#endif
    return flags;
  }
} // namespace semilunar

#endif
