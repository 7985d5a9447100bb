// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/shell/assembly.h>
#include <semilunar/shell/element_matrix.h>
#include <semilunar/shell/midsurface_step.h>
#include <semilunar/shell/tangent_frame.h>

#include <deal.II/base/parallel.h>
#include <deal.II/base/work_stream.h>

#include <cmath>
#include <numeric>
#include <sstream>

namespace semilunar::shell
{
  using namespace spline;

  struct Assembly::Scratch
  {
    std::vector<double> positions; // 3 x stride
    std::vector<double> end_positions;
    PointResponse response;
    ElementMatrix matrix;
  };

  struct Assembly::ElementResult
  {
    unsigned int element = 0;
    double energy = 0.;
    std::vector<double> forces, block;
  };

  namespace
  {
    constexpr unsigned int elements_per_task = 8;

    /// Gather the control points of an element as rows x, y, z, padded with zeros.
    void gather(const BezierElement &element, const ControlVectors &x, const unsigned int stride,
                std::vector<double> &rows)
    {
      rows.assign(3 * stride, 0.);
      for (unsigned int a = 0; a < element.n_functions(); ++a)
        for (unsigned int i = 0; i < 3; ++i)
          rows[i * stride + a] = x[element.control_points[a]][i];
    }
    /// Larger absolute value of the two principal curvatures, b in an orthonormal frame.
    double largest_curvature(const Symmetric &b)
    {
      const double mean = 0.5 * (b[0] + b[1]);
      return std::abs(mean) + std::hypot(0.5 * (b[0] - b[1]), b[2]);
    }

    /// The metric 1 - 2 xi b0 must be positive definite through the thickness.
    void check_curvature(const Symmetric &b0, const double thickness, const Tensor<1, 3> &place)
    {
      const double curvature = largest_curvature(b0);
      if (!(curvature * thickness < 1.))
      {
        std::ostringstream where;
        where << "(" << place[0] << ", " << place[1] << ", " << place[2] << ")";
        throw InputError("Shell/Thickness", std::to_string(thickness),
                         "the undeformed surface is bent too tightly for a shell this thick near " +
                             where.str(),
                         "its radius of curvature there is " + std::to_string(1. / curvature) +
                             ": make the shell thinner than that, or the surface rounder");
      }
    }
  } // namespace

  Assembly::Assembly(const Surface &surface, const QuadraturePoints &points, const Section &section,
                     const FibreField &fibres)
      : surface(surface), points(points), section(section), fibres(fibres),
        undeformed_positions(positions(surface)), undeformed_b(points.n_points()),
        fibre_directions(points.n_points())
  {
    std::vector<double> rows;
    for (unsigned int e = 0; e < surface.elements.size(); ++e)
    {
      gather(surface.elements[e], undeformed_positions, points.stride(e), rows);
      for (unsigned int q = points.first_point(e); q < points.first_point(e + 1); ++q)
      {
        const SurfaceJet undeformed = jet(rows.data(), q);
        undeformed_b[q] = fundamental_forms(undeformed).b;
        check_curvature(undeformed_b[q], section.thickness(), undeformed[value]);
        fibre_directions[q] = fibres(undeformed[value], points.frame(q));
      }
    }
  }

  SurfaceJet Assembly::jet(const double *rows, const unsigned int q) const
  {
    const unsigned int stride = points.stride(points.element(q));
    SurfaceJet result;
    for (unsigned int d = 0; d < n_derivatives; ++d)
    {
      const double *basis = points.basis(q, static_cast<Derivative>(d));
      for (unsigned int i = 0; i < 3; ++i)
        result[d][i] = std::inner_product(basis, basis + stride, rows + i * stride, 0.);
    }
    return result;
  }

  void Assembly::element_response(const unsigned int element, const ControlVectors &x,
                                  const double pressure, const bool with_tangent,
                                  const std::vector<Resultants> *const predicted, Scratch &scratch,
                                  ElementResult &result) const
  {
    const BezierElement &bezier = surface.elements[element];
    const unsigned int stride = points.stride(element);
    gather(bezier, x, stride, scratch.positions);
    scratch.matrix.reinit(bezier.n_functions(), stride, with_tangent);
    result.element = element;
    result.energy = 0.;
    for (unsigned int q = points.first_point(element); q < points.first_point(element + 1); ++q)
    {
      const SurfaceJet deformed = jet(scratch.positions.data(), q);
      const double energy =
          strain_response(section, deformed, undeformed_b[q], fibre_directions[q], with_tangent,
                          scratch.response, predicted == nullptr ? nullptr : &(*predicted)[q]);
      if (pressure != 0.)
        add_pressure(deformed, pressure, with_tangent, scratch.response);
      result.energy += points.weight(q) * energy;
      scratch.matrix.add(scratch.response, points.basis(q, value), points.weight(q));
    }
    result.forces.assign(scratch.matrix.force(), scratch.matrix.force() + 3 * bezier.n_functions());
    if (with_tangent)
      scratch.matrix.copy_matrix(result.block);
  }

  double Assembly::add(const ControlVectors &x, const double pressure, ControlVectors &forces,
                       const AddBlock &add_block,
                       const std::vector<Resultants> *const predicted) const
  {
    double energy = 0.;
    const bool with_tangent = static_cast<bool>(add_block);
    std::vector<unsigned int> elements(surface.elements.size());
    std::iota(elements.begin(), elements.end(), 0u);
    dealii::WorkStream::run(
        elements.begin(), elements.end(),
        [&](const std::vector<unsigned int>::iterator &element, Scratch &scratch,
            ElementResult &result)
        { element_response(*element, x, pressure, with_tangent, predicted, scratch, result); },
        [&](const ElementResult &result)
        {
          const auto &control_points = surface.elements[result.element].control_points;
          energy += result.energy;
          for (unsigned int a = 0; a < control_points.size(); ++a)
            for (unsigned int i = 0; i < 3; ++i)
              forces[control_points[a]][i] += result.forces[3 * a + i];
          if (with_tangent)
            add_block(control_points, result.block.data());
        },
        Scratch(), ElementResult());
    return energy;
  }

  void Assembly::add_conserving(const ControlVectors &from, const ControlVectors &to,
                                ControlVectors &forces) const
  {
    std::vector<unsigned int> elements(surface.elements.size());
    std::iota(elements.begin(), elements.end(), 0u);
    dealii::WorkStream::run(
        elements.begin(), elements.end(),
        [&](const std::vector<unsigned int>::iterator &element, Scratch &scratch,
            ElementResult &result) { element_conserving(*element, from, to, scratch, result); },
        [&](const ElementResult &result)
        {
          const auto &control_points = surface.elements[result.element].control_points;
          for (unsigned int a = 0; a < control_points.size(); ++a)
            for (unsigned int i = 0; i < 3; ++i)
              forces[control_points[a]][i] += result.forces[3 * a + i];
        },
        Scratch(), ElementResult());
  }

  void Assembly::element_conserving(const unsigned int element, const ControlVectors &from,
                                    const ControlVectors &to, Scratch &scratch,
                                    ElementResult &result) const
  {
    const BezierElement &bezier = surface.elements[element];
    const unsigned int stride = points.stride(element);
    gather(bezier, from, stride, scratch.positions);
    gather(bezier, to, stride, scratch.end_positions);
    scratch.matrix.reinit(bezier.n_functions(), stride, false);
    result.element = element;
    for (unsigned int q = points.first_point(element); q < points.first_point(element + 1); ++q)
    {
      conserving_gradient(section, jet(scratch.positions.data(), q),
                          jet(scratch.end_positions.data(), q), undeformed_b[q],
                          fibre_directions[q], scratch.response.gradient);
      scratch.matrix.add(scratch.response, points.basis(q, value), points.weight(q));
    }
    result.forces.assign(scratch.matrix.force(), scratch.matrix.force() + 3 * bezier.n_functions());
  }

  std::vector<Resultants> Assembly::predict(const ControlVectors &x, const ControlVectors &dx) const
  {
    std::vector<Resultants> resultants(points.n_points());
    dealii::parallel::apply_to_subranges(
        0u, static_cast<unsigned int>(surface.elements.size()),
        [&](const unsigned int begin, const unsigned int end)
        {
          std::vector<double> rows, changes;
          for (unsigned int e = begin; e < end; ++e)
          {
            gather(surface.elements[e], x, points.stride(e), rows);
            gather(surface.elements[e], dx, points.stride(e), changes);
            for (unsigned int q = points.first_point(e); q < points.first_point(e + 1); ++q)
              resultants[q] =
                  predict_resultants(section, jet(rows.data(), q), jet(changes.data(), q),
                                     undeformed_b[q], fibre_directions[q]);
          }
        },
        elements_per_task);
    return resultants;
  }

  double Assembly::point_response(const ControlVectors &x, const unsigned int q,
                                  const double pressure, const Resultants &predicted,
                                  PointResponse &response) const
  {
    const unsigned int e = points.element(q);
    std::vector<double> rows;
    gather(surface.elements[e], x, points.stride(e), rows);
    const SurfaceJet deformed = jet(rows.data(), q);
    const double energy = strain_response(section, deformed, undeformed_b[q], fibre_directions[q],
                                          true, response, &predicted);
    add_pressure(deformed, pressure, false, response);
    return energy;
  }

  SectionStrain Assembly::section_strain(const ControlVectors &x, const unsigned int q) const
  {
    const unsigned int e = points.element(q);
    std::vector<double> rows;
    gather(surface.elements[e], x, points.stride(e), rows);
    const FundamentalForms forms = fundamental_forms(jet(rows.data(), q));
    return {forms.a, forms.b, undeformed_b[q], fibre_directions[q]};
  }

  SectionStrain Assembly::section_strain(const ControlVectors &x, const SurfacePoint &point) const
  {
    const BezierElement &element = surface.elements[point.element];
    BasisValues basis;
    evaluate_basis(surface, point.element, point.xi, basis);
    SurfaceJet undeformed = interpolate(element, basis, undeformed_positions);
    const TangentFrame frame(undeformed[d1], undeformed[d2]);
    undeformed = frame.transform(undeformed);
    const FundamentalForms forms =
        fundamental_forms(frame.transform(interpolate(element, basis, x)));
    return {forms.a, forms.b, fundamental_forms(undeformed).b, fibres(undeformed[value], frame.e)};
  }
} // namespace semilunar::shell
