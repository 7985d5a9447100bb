// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/shell/supports.h>

#include <deal.II/base/utilities.h>

#include <limits>

namespace semilunar::shell
{
  namespace
  {
    const std::string entry = "Supports/Supports";

    constexpr const char *verbs = "the verbs are: fix PLACE xyz | pin PLACE | clamp PLACE | "
                                  "symmetry PLANE | symmetry PLACE x | tie PLACE OTHER xyz | "
                                  "move PLACE x VALUE";

    std::vector<unsigned int> parse_components(const std::string &word)
    {
      std::vector<unsigned int> components;
      for (const char c : word)
        if (c >= 'x' && c <= 'z')
          components.push_back(c - 'x');
        else
          throw InputError(entry, word, "these are not components", "write some of xyz");
      return components;
    }

    /// For each point of row 1 the nearest of row 0, distances measured without the given axis (3:
    /// with all).
    std::vector<std::pair<unsigned int, unsigned int>>
    nearest_pairs(const spline::Surface &surface, const std::vector<unsigned int> &row_1,
                  const std::vector<unsigned int> &row_0, const unsigned int without_axis)
    {
      std::vector<std::pair<unsigned int, unsigned int>> pairs;
      for (const unsigned int c : row_1)
      {
        unsigned int nearest = row_0.front();
        double smallest = std::numeric_limits<double>::max();
        for (const unsigned int d : row_0)
        {
          auto offset = surface.control_points[c].position - surface.control_points[d].position;
          if (without_axis < 3)
            offset[without_axis] = 0.;
          if (offset.norm_square() < smallest)
          {
            smallest = offset.norm_square();
            nearest = d;
          }
        }
        if (nearest != c)
          pairs.emplace_back(c, nearest);
      }
      return pairs;
    }

    /// Applies the supports of the list one after the other.
    class Builder
    {
    public:
      Builder(const spline::Surface &surface, Equations &equations)
          : surface(surface), equations(equations)
      {
      }

      void apply(const std::string &statement)
      {
        const std::vector<std::string> words = split_words(statement);
        const auto has = [&](const char *verb, const unsigned int n)
        { return words[0] == verb && words.size() == n; };
        if (has("fix", 3))
          prescribe(locate(words[1]).control_points, parse_components(words[2]), 0.);
        else if (has("pin", 2))
          prescribe(locate(words[1]).control_points, {0, 1, 2}, 0.);
        else if (has("clamp", 2))
        {
          const Location place = locate(words[1]);
          prescribe(place.control_points, {0, 1, 2}, 0.);
          prescribe(second_row(surface, place, entry), {0, 1, 2}, 0.);
        }
        else if (has("symmetry", 2) || has("symmetry", 3))
          symmetry(locate(words[1]), words.size() == 3 ? words[2] : "");
        else if (has("tie", 4))
          tie(locate(words[1]).control_points, locate(words[2]).control_points,
              parse_components(words[3]), 3);
        else if (has("move", 4))
          prescribe(locate(words[1]).control_points, parse_components(words[2]),
                    parse_number(words[3], entry));
        else
          throw InputError(entry, statement, "this support is not understood", verbs);
      }

    private:
      const spline::Surface &surface;
      Equations &equations;

      Location locate(const std::string &word) const { return find_location(surface, word, entry); }

      void prescribe(const std::vector<unsigned int> &points,
                     const std::vector<unsigned int> &components, const double value)
      {
        for (const unsigned int c : points)
          for (const unsigned int i : components)
            equations.prescribe(c, i, value);
      }

      void tie(const std::vector<unsigned int> &row_1, const std::vector<unsigned int> &row_0,
               const std::vector<unsigned int> &components, const unsigned int without_axis)
      {
        for (const auto &[c, d] : nearest_pairs(surface, row_1, row_0, without_axis))
          for (const unsigned int i : components)
            equations.tie(c, d, i);
      }

      void symmetry(const Location &place, const std::string &axis_word)
      {
        if (place.axis && !axis_word.empty())
          throw InputError(entry, place.text + " " + axis_word, "a plane has its own normal",
                           "write symmetry " + place.text);
        if (!place.axis && axis_word.size() != 1)
          throw InputError(entry, place.text, "the normal of the symmetry plane is missing",
                           "write symmetry PLANE, or symmetry SET x");
        const unsigned int axis = place.axis ? *place.axis : parse_components(axis_word)[0];
        const auto sides = location_sides(surface, place, entry);
        const auto row_0 = control_row(surface, sides, 0);
        prescribe(row_0, {axis}, 0.);
        // The tangent across the edge stays normal to the plane: the second row follows the first
        // within the plane.
        tie(control_row(surface, sides, 1), row_0, {(axis + 1) % 3, (axis + 2) % 3}, axis);
      }
    };
  } // namespace

  void SupportParameters::add_parameters(dealii::ParameterHandler &prm)
  {
    prm.enter_subsection("Supports");
    prm.add_parameter("Supports", supports,
                      "Supports, separated by semicolons. A PLACE is a node set of the surface "
                      "(left), a coordinate "
                      "plane (x=0), or the control point nearest to a point ((0,0,1)). 'fix PLACE "
                      "xyz' holds the named "
                      "components of the place's control points; 'pin PLACE' holds all three; "
                      "'clamp PLACE' also holds "
                      "the second row of control points, and so the rotation and the stretch next "
                      "to the edge; 'pin left; fix nextLeft z' leaves the stretch of a flat patch "
                      "free; 'symmetry PLANE' (or "
                      "'symmetry PLACE x' "
                      "with the plane's normal) keeps the edge in the plane and the surface normal "
                      "to it, for mesh lines that cross the plane at right angles; 'tie PLACE "
                      "OTHER xyz' makes each control point of PLACE follow the nearest one of "
                      "OTHER; 'move PLACE x VALUE' "
                      "prescribes a displacement, proportional to the load factor.");
    prm.leave_subsection();
  }

  Equations make_equations(const spline::Surface &surface, const SupportParameters &parameters)
  {
    Equations equations(surface.control_points.size());
    Builder builder(surface, equations);
    for (const std::string &statement :
         dealii::Utilities::split_string_list(parameters.supports, ';'))
      if (!statement.empty())
        builder.apply(statement);
    equations.close();
    if (parameters.may_move_rigidly)
      return equations;

    const std::vector<unsigned int> n_free = free_rigid_motions(surface, equations);
    for (unsigned int part = 0; part < n_free.size(); ++part)
      if (n_free[part] > 0)
        throw InputError(entry, parameters.supports,
                         "piece " + std::to_string(part + 1) + " of " +
                             std::to_string(n_free.size()) +
                             " of the surface can still move rigidly in " +
                             std::to_string(n_free[part]) + " independent ways",
                         "hold it: three translations and three rotations");
    return equations;
  }
} // namespace semilunar::shell
