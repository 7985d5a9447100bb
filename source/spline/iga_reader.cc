// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/spline/bernstein.h>
#include <semilunar/spline/iga_file.h>
#include <semilunar/spline/iga_tokens.h>
#include <semilunar/spline/surface_check.h>

#include <algorithm>
#include <cmath>

namespace semilunar::spline
{
  namespace
  {
    /// "what 3 of 17", counted from one, for messages.
    std::string count(const char *what, const unsigned int index, const unsigned int n)
    {
      return std::string(what) + " " + std::to_string(index + 1) + " of " + std::to_string(n);
    }

    struct Header
    {
      unsigned int n_nodes, n_elements;
    };

    Header read_header(IgaTokens &tokens)
    {
      tokens.next_line("type surface");
      tokens.keyword("type");
      const std::string type(tokens.token("surface or plane"));
      if (type != "surface" && type != "plane")
        tokens.fail(type, "unknown type", "surface and plane are supported");
      tokens.end_of_line("the type only");

      const auto counter = [&tokens](const char *keyword)
      {
        tokens.next_line(keyword);
        tokens.keyword(keyword);
        const unsigned int n = tokens.index("a count");
        if (n == 0)
          tokens.fail("0", "there is nothing in this file", "at least 1 is needed");
        tokens.end_of_line("one count");
        return n;
      };
      const unsigned int n_nodes = counter("nodeN");
      return {n_nodes, counter("elemN")};
    }

    ControlPoint read_node(IgaTokens &tokens, const double scale)
    {
      tokens.keyword("node");
      ControlPoint point;
      for (unsigned int d = 0; d < 3; ++d)
        point.position[d] = scale * tokens.number("a coordinate");
      point.weight = tokens.number("a weight");
      tokens.end_of_line("x y z w");
      return point;
    }

    void read_rows(IgaTokens &tokens, const unsigned int n, BezierElement &element)
    {
      const unsigned int m = element.n_bernstein();
      element.extraction.reserve(std::min(std::size_t(n) * m, tokens.size()));
      for (unsigned int a = 0; a < n; ++a)
      {
        tokens.next_line(count("row", a, n));
        for (unsigned int b = 0; b < m; ++b)
          element.extraction.push_back(tokens.number("an extraction coefficient"));
        tokens.end_of_line("(p + 1) (q + 1) extraction coefficients");
      }
    }

    BezierElement read_element(IgaTokens &tokens, const unsigned int n_nodes)
    {
      tokens.keyword("belem");
      const unsigned int n = tokens.index("the number of functions");
      BezierElement element;
      for (unsigned int &degree : element.degree)
      {
        degree = tokens.index("a degree");
        if (degree < 1 || degree > max_degree)
          tokens.fail(std::to_string(degree), "the degree is not supported",
                      "degrees from 1 to " + std::to_string(max_degree) + " are");
      }
      tokens.end_of_line("n p q");

      tokens.next_line("the control points of the element");
      for (unsigned int a = 0; a < n; ++a)
        element.control_points.push_back(tokens.index("a control point", n_nodes));
      tokens.end_of_line("n control points");
      read_rows(tokens, n, element);
      return element;
    }

    NamedSet read_set(IgaTokens &tokens, const Surface &surface)
    {
      tokens.keyword("set");
      const unsigned int n = tokens.index("the number of members");
      const std::string kind(tokens.token("node, elem or side"));
      NamedSet set;
      if (kind == "node")
        set.kind = SetKind::node;
      else if (kind == "elem")
        set.kind = SetKind::element;
      else if (kind == "side")
        set.kind = SetKind::side;
      else
        tokens.fail(kind, "unknown kind of set", "node, elem and side are known");
      set.name = tokens.token("the name of the set");
      if (surface.find_set(set.kind, set.name) != nullptr)
        tokens.fail(set.name, "there are two sets of this kind and name", "rename one");

      while (!tokens.at_end_of_line())
        set.members.push_back(tokens.index("a member"));
      // writers differ in whether they count the sides or the numbers
      const bool fits = set.members.size() == n ||
                        (set.kind == SetKind::side && set.members.size() == 2 * std::size_t(n));
      if (!fits)
        tokens.fail(std::to_string(n), "wrong count of set members",
                    std::to_string(set.members.size()) + " follow");
      return set;
    }

    /// The lines on which things began, for messages about them.
    using Lines = std::array<std::vector<unsigned int>, 3>;

    Surface read_surface(IgaTokens &tokens, const double scale, Lines &lines)
    {
      const Header header = read_header(tokens);
      Surface surface;
      surface.control_points.reserve(std::min<std::size_t>(header.n_nodes, tokens.size()));
      surface.elements.reserve(std::min<std::size_t>(header.n_elements, tokens.size()));
      for (unsigned int i = 0; i < header.n_nodes; ++i)
      {
        tokens.next_line(count("node", i, header.n_nodes));
        lines[SurfaceDefect::control_point].push_back(tokens.line_number());
        surface.control_points.push_back(read_node(tokens, scale));
      }
      for (unsigned int e = 0; e < header.n_elements; ++e)
      {
        tokens.next_line(count("belem", e, header.n_elements));
        lines[SurfaceDefect::element].push_back(tokens.line_number());
        surface.elements.push_back(read_element(tokens, header.n_nodes));
      }
      while (tokens.next_line())
      {
        lines[SurfaceDefect::set].push_back(tokens.line_number());
        surface.sets.push_back(read_set(tokens, surface));
      }
      return surface;
    }
  } // namespace

  Surface read_iga(const std::string &filename, const double scale)
  {
    if (!(scale > 0.) || !std::isfinite(scale))
      throw InputError("scale of " + filename, std::to_string(scale), "not a positive number",
                       "1 keeps the file's unit");
    IgaTokens tokens(filename);
    Lines lines;
    Surface surface = read_surface(tokens, scale, lines);
    if (const auto defect = first_defect(surface))
      tokens.fail_at(lines[defect->place][defect->index], defect->value, defect->problem,
                     defect->remedy);
    return surface;
  }
} // namespace semilunar::spline
