// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_shell_equations_h
#define semilunar_shell_equations_h

#include <deal.II/base/tensor.h>
#include <deal.II/lac/vector.h>

#include <vector>

namespace semilunar::shell
{
  /// Which equation each displacement component of each control point belongs to. Components may be
  /// prescribed (no equation) or tied to each other (the same equation).
  class Equations
  {
  public:
    /// All components free.
    explicit Equations(unsigned int n_control_points);

    /// The displacement is value times the load factor. This and tie() throw an InputError for two
    /// different values of one component.
    void prescribe(unsigned int control_point, unsigned int component, double value);
    /// Both displacements are equal.
    void tie(unsigned int control_point, unsigned int other, unsigned int component);
    /// Number the free components. Call once after all of the above.
    void close();

    unsigned int n_equations() const { return n; }
    unsigned int n_control_points() const { return numbers.size() / 3; }
    static constexpr unsigned int none = static_cast<unsigned int>(-1);
    /// Equation of a component, or none if it is prescribed.
    unsigned int operator()(unsigned int control_point, unsigned int component) const
    {
      return numbers[3 * control_point + component];
    }

    /// A representative component for each class of tied ones: equal for tied components.
    unsigned int representative(unsigned int control_point, unsigned int component) const;
    bool is_prescribed(unsigned int control_point, unsigned int component) const
    {
      return (*this)(control_point, component) == none;
    }

    /// Whether a displacement other than zero is prescribed.
    bool moves_supports() const;

    /// Displacements of all control points, prescribed ones at this load factor.
    void expand(const dealii::Vector<double> &solution, double load_factor,
                std::vector<dealii::Tensor<1, 3>> &displacements) const;
    /// The free components of displacements that obey the ties: the inverse of expand().
    void gather(const std::vector<dealii::Tensor<1, 3>> &displacements,
                dealii::Vector<double> &solution) const;
    /// Add up the components of each equation (the transpose of expand).
    void restrict(const std::vector<dealii::Tensor<1, 3>> &forces,
                  dealii::Vector<double> &residual) const;

  private:
    unsigned int n = 0;
    std::vector<unsigned int> parents, numbers;
    std::vector<bool> held;
    std::vector<double> values;
  };
} // namespace semilunar::shell

#endif
