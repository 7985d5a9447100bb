// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/spline/bernstein.h>
#include <semilunar/spline/cap_conditions.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/lapack_full_matrix.h>
#include <deal.II/lac/vector.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace semilunar::spline
{
  namespace
  {
    constexpr unsigned int d = cap_degree, n_coefficients = (d + 1) * (d + 1);

    using Matrix = dealii::LAPACKFullMatrix<double>;
    using Vector = dealii::Vector<double>;

    /// The conditions on the coefficients that are not given, and all solutions of them.
    class SolutionSpace
    {
    public:
      SolutionSpace(const CapConditions &all, const std::set<unsigned int> &numbers) : all(all)
      {
        for (const unsigned int i : numbers)
          if (all.given().count(i) == 0)
            unknowns.push_back(i);
        for (unsigned int k = 0; k < unknowns.size(); ++k)
          place[unknowns[k]] = k;
        Matrix A(all.conditions().size(), unknowns.size());
        A = 0.;
        for (unsigned int r = 0; r < all.conditions().size(); ++r)
          for (const auto &[i, factor] : all.conditions()[r])
            if (all.given().count(i) == 0)
              A(r, place[i]) = factor;
        inverse = A;
        constexpr double dependent = 1e-10; // of the largest singular value
        inverse.compute_inverse_svd(dependent);
        A.compute_svd();
        rank = 0;
        const unsigned int n_values = std::min(A.m(), A.n());
        while (rank < n_values && A.singular_value(rank) > dependent * A.singular_value(0))
          ++rank;
        right_vectors = A.get_svd_vt();
      }

      const std::vector<unsigned int> &free_numbers() const { return unknowns; }

      /// The nearest coefficients that meet all conditions, (U7), for one control point.
      void correct(Vector &x, const unsigned int control_point) const
      {
        Vector change(x.size());
        // twice: the second time removes the round-off of the first
        for (unsigned int k = 0; k < 2; ++k)
        {
          inverse.vmult(change, defects(x, control_point));
          x += change;
        }
        if (defects(x, control_point).linfty_norm() > 1e-11)
          throw NumericsError("the conditions at an extraordinary point contradict each other",
                              "control point " + std::to_string(control_point), "");
      }

      /// Unknowns that determine all others if nothing is given, and the solutions in which one of
      /// them is 1 and the others are 0: rows of `solutions`.
      struct Basis
      {
        std::vector<unsigned int> determining;
        dealii::FullMatrix<double> solutions = dealii::FullMatrix<double>();
      };

      /// Chosen by elimination with the largest pivots.
      Basis basis() const
      {
        const unsigned int n = unknowns.size(), m = n - rank;
        Basis result;
        result.solutions.reinit(m, n);
        dealii::FullMatrix<double> &Z = result.solutions;
        for (unsigned int k = 0; k < m; ++k)
          for (unsigned int i = 0; i < n; ++i)
            Z(k, i) = right_vectors(rank + k, i);
        for (unsigned int step = 0; step < m; ++step)
        {
          unsigned int row = step, column = 0;
          for (unsigned int k = step; k < m; ++k)
            for (unsigned int i = 0; i < n; ++i)
              if (std::abs(Z(k, i)) > std::abs(Z(row, column)))
              {
                row = k;
                column = i;
              }
          Z.swap_row(row, step);
          const double pivot = Z(step, column);
          for (unsigned int i = 0; i < n; ++i)
            Z(step, i) /= pivot;
          for (unsigned int k = 0; k < m; ++k)
            if (k != step)
              Z.add_row(k, -Z(k, column), step);
          result.determining.push_back(column);
        }
        return result;
      }

    private:
      const CapConditions &all;
      std::vector<unsigned int> unknowns;
      std::map<unsigned int, unsigned int> place;
      Matrix inverse, right_vectors;
      unsigned int rank;

      /// What a set of coefficients misses in each condition, for one control point.
      Vector defects(const Vector &x, const unsigned int control_point) const
      {
        Vector defect(all.conditions().size());
        for (unsigned int r = 0; r < all.conditions().size(); ++r)
          for (const auto &[i, factor] : all.conditions()[r])
          {
            const auto given = all.given().find(i);
            defect[r] -=
                factor *
                (given == all.given().end() ? x[place.at(i)] : given->second.factor(control_point));
          }
        return defect;
      }
    };

    void add_control_points(const FaceCoefficients &face, std::set<unsigned int> &points)
    {
      for (const LinearForm &form : face)
        for (const auto &term : form.terms)
          points.insert(term.first);
    }

    /// Writes what was found for each control point into the faces.
    class CapWriter
    {
    public:
      CapWriter(const CapConditions &conditions, const std::vector<unsigned int> &faces)
          : conditions(conditions), faces(faces), forms(faces.size() * n_coefficients)
      {
        for (const auto &[i, form] : conditions.given())
          forms[i] = form;
      }

      void set(const unsigned int number, const unsigned int function, const double x)
      {
        constexpr double round_off = 1e-15;
        if (std::abs(x) > round_off)
          forms[number].terms[function] = x;
      }

      std::map<unsigned int, FaceCoefficients> result() const
      {
        std::map<unsigned int, FaceCoefficients> cap;
        for (const unsigned int f : faces)
          for (unsigned int k = 0; k < n_coefficients; ++k)
            cap[f].push_back(forms[conditions.number(f, k)]);
        return cap;
      }

    private:
      const CapConditions &conditions;
      const std::vector<unsigned int> &faces;
      std::vector<LinearForm> forms;
    };
  } // namespace

  unsigned int side_index(const unsigned int degree, const unsigned int side,
                          const unsigned int along, const unsigned int inside)
  {
    const unsigned int n = degree;
    const unsigned int i[4] = {along, n - inside, n - along, inside};
    const unsigned int j[4] = {inside, along, n - inside, n - along};
    return j[side] * (n + 1) + i[side];
  }

  FaceCoefficients elevated(const FaceCoefficients &bicubic)
  {
    // B_k^3 = sum_i E_ki B_i^5
    double E[4][d + 1] = {};
    for (unsigned int k = 0; k < 4; ++k)
      for (unsigned int i = k; i <= k + 2; ++i)
        E[k][i] = binomial(3, k) * binomial(2, i - k) / binomial(5, i);
    FaceCoefficients result(n_coefficients);
    for (unsigned int l = 0; l < 4; ++l)
      for (unsigned int k = 0; k < 4; ++k)
        for (unsigned int j = l; j <= l + 2; ++j)
          for (unsigned int i = k; i <= k + 2; ++i)
            result[j * (d + 1) + i].add(E[k][i] * E[l][j], bicubic[4 * l + k]);
    return result;
  }

  namespace
  {
    /// What a cap starts from, by the numbers of its coefficients.
    struct Start
    {
      std::set<unsigned int> control_points, numbers;
      std::map<unsigned int, LinearForm> coefficients;

      Start(const CapConditions &conditions, const std::vector<unsigned int> &faces,
            const std::map<unsigned int, FaceCoefficients> &regular,
            const std::map<unsigned int, FaceCoefficients> &initial)
      {
        for (const auto &neighbour : regular)
          add_control_points(neighbour.second, control_points);
        for (const unsigned int f : faces)
        {
          add_control_points(initial.at(f), control_points);
          for (unsigned int k = 0; k < n_coefficients; ++k)
          {
            numbers.insert(conditions.number(f, k));
            coefficients[conditions.number(f, k)] = initial.at(f)[k];
          }
        }
      }
    };
  } // namespace

  G1Cap g1_cap(const QuadMesh &mesh, const std::vector<unsigned int> &faces,
               const std::map<unsigned int, FaceCoefficients> &regular,
               const std::map<unsigned int, FaceCoefficients> &initial,
               const bool with_own_functions, const unsigned int first_own)
  {
    const CapConditions conditions(mesh, faces, regular);
    const Start start(conditions, faces, regular, initial);
    const SolutionSpace space(conditions, start.numbers);
    const SolutionSpace::Basis basis = with_own_functions ? space.basis() : SolutionSpace::Basis{};
    const std::vector<unsigned int> &unknowns = space.free_numbers();

    CapWriter writer(conditions, faces);
    G1Cap cap;
    cap.own.resize(basis.determining.size());
    for (unsigned int k = 0; k < cap.own.size(); ++k)
      for (unsigned int i = 0; i < unknowns.size(); ++i)
        writer.set(unknowns[i], first_own + k, basis.solutions(k, i));
    Vector x(unknowns.size());
    for (const unsigned int c : start.control_points)
    {
      for (unsigned int i = 0; i < unknowns.size(); ++i)
        x[i] = start.coefficients.at(unknowns[i]).factor(c);
      space.correct(x, c);
      // what the cap's own functions shall say, the control point's function must not
      for (unsigned int k = 0; k < cap.own.size(); ++k)
      {
        const double share = x[basis.determining[k]];
        if (share == 0.)
          continue;
        cap.own[k].terms[c] = share;
        for (unsigned int i = 0; i < unknowns.size(); ++i)
          x[i] -= share * basis.solutions(k, i);
      }
      constexpr double nothing = 1e-10; // left of a function that is wholly inside of the cap
      if (x.size() > 0 && x.linfty_norm() > nothing)
        for (unsigned int i = 0; i < unknowns.size(); ++i)
          writer.set(unknowns[i], c, x[i]);
    }
    cap.faces = writer.result();
    return cap;
  }
} // namespace semilunar::spline
