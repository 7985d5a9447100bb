// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_shell_assembly_h
#define semilunar_shell_assembly_h

#include <semilunar/shell/midsurface_point.h>
#include <semilunar/shell/quadrature_points.h>

#include <functional>

namespace semilunar::shell
{
  using ControlVectors = std::vector<spline::Tensor<1, 3>>;

  /// Sums the midsurface points up to energy, forces on the control points, and tangent blocks.
  class Assembly
  {
  public:
    /// Fibre direction, two components in the frame of the point at this position.
    using FibreField = std::function<std::array<double, 2>(
        const spline::Tensor<1, 3> &position, const std::array<spline::Tensor<1, 3>, 2> &frame)>;

    /// @throws InputError if the surface is bent more tightly than the section is thick
    Assembly(const spline::Surface &surface, const QuadraturePoints &points, const Section &section,
             const FibreField &fibres);

    /// Takes the tangent of one element: (3n) x (3n), row by row, index 3 a + i.
    using AddBlock =
        std::function<void(const std::vector<unsigned int> &control_points, const double *block)>;

    /// Strain energy with control points at x. Adds internal forces minus those of the follower
    /// pressure to the forces, and hands each element's derivative of them to add_block unless that
    /// is empty. Elements are computed by all threads and added in their order: the sums do not
    /// depend on the number of threads.
    /// @param predicted resultants at the quadrature points for the geometric part of the tangent
    /// in place of those of the state, unless null
    double add(const ControlVectors &x, double pressure, ControlVectors &forces,
               const AddBlock &add_block, const std::vector<Resultants> *predicted = nullptr) const;

    /// The resultants at all quadrature points that the linearisation at x predicts after a change
    /// dx: (K12).
    std::vector<Resultants> predict(const ControlVectors &x, const ControlVectors &dx) const;

    /// Add the internal forces of the energy-momentum method between two positions of the control
    /// points: conserving_gradient() at all points.
    void add_conserving(const ControlVectors &from, const ControlVectors &to,
                        ControlVectors &forces) const;

    /// Energy per undeformed area of a quadrature point with control points at x, and its response,
    /// pressure included: what add() sums up. @return the energy
    double point_response(const ControlVectors &x, unsigned int q, double pressure,
                          const Resultants &predicted, PointResponse &response) const;

    /// What the section sees at any point of the surface with control points at x.
    SectionStrain section_strain(const ControlVectors &x, const spline::SurfacePoint &point) const;
    /// The same at a quadrature point.
    SectionStrain section_strain(const ControlVectors &x, unsigned int q) const;

  private:
    const spline::Surface &surface;
    const QuadraturePoints &points;
    const Section &section;
    FibreField fibres;
    ControlVectors undeformed_positions;
    std::vector<Symmetric> undeformed_b;
    std::vector<std::array<double, 2>> fibre_directions;

    struct Scratch;
    struct ElementResult;
    spline::SurfaceJet jet(const double *positions, unsigned int q) const;
    void element_response(unsigned int element, const ControlVectors &x, double pressure,
                          bool with_tangent, const std::vector<Resultants> *predicted,
                          Scratch &scratch, ElementResult &result) const;
    void element_conserving(unsigned int element, const ControlVectors &from,
                            const ControlVectors &to, Scratch &scratch,
                            ElementResult &result) const;
  };
} // namespace semilunar::shell

#endif
