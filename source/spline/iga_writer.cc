// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/spline/iga_file.h>

#include <charconv>
#include <fstream>

namespace semilunar::spline
{
  namespace
  {
    /// Append a number: for doubles the shortest text that reads back as the same number.
    template <typename Number>
    void write(std::string &text, const Number x)
    {
      char buffer[32];
      const auto result = std::to_chars(buffer, buffer + sizeof(buffer), x);
      text.append(buffer, result.ptr);
    }

    template <typename Number>
    void write_line(std::string &text, const Number *begin, const std::size_t n)
    {
      for (std::size_t k = 0; k < n; ++k)
      {
        if (k > 0)
          text += ' ';
        write(text, begin[k]);
      }
      text += '\n';
    }

    void write(std::string &text, const ControlPoint &point)
    {
      const double numbers[] = {point.position[0], point.position[1], point.position[2],
                                point.weight};
      text += "node ";
      write_line(text, numbers, 4);
    }

    void write(std::string &text, const BezierElement &element)
    {
      const unsigned int header[] = {element.n_functions(), element.degree[0], element.degree[1]};
      text += "belem ";
      write_line(text, header, 3);
      write_line(text, element.control_points.data(), element.control_points.size());
      for (unsigned int a = 0; a < element.n_functions(); ++a)
        write_line(text, &element.extraction[std::size_t(a) * element.n_bernstein()],
                   element.n_bernstein());
    }

    void write(std::string &text, const NamedSet &set)
    {
      const bool is_side = set.kind == SetKind::side;
      text += "set ";
      write(text, set.members.size() / (is_side ? 2 : 1));
      text += is_side ? " side " : set.kind == SetKind::element ? " elem " : " node ";
      text += set.name + ' ';
      write_line(text, set.members.data(), set.members.size());
    }
  } // namespace

  void write_iga(const Surface &surface, const std::string &filename)
  {
    for (const NamedSet &set : surface.sets)
      if (set.name.empty() || set.name.find_first_of(" \t\r\n\f\v") != std::string::npos)
        throw InputError(filename, set.name, "this name of a set cannot be written",
                         "use a name without blanks");

    std::string text = "type surface\nnodeN " + std::to_string(surface.control_points.size()) +
                       "\nelemN " + std::to_string(surface.elements.size()) + "\n";
    for (const ControlPoint &point : surface.control_points)
      write(text, point);
    for (const BezierElement &element : surface.elements)
      write(text, element);
    for (const NamedSet &set : surface.sets)
      write(text, set);

    std::ofstream file(filename, std::ios::binary);
    file << text;
    file.close();
    if (!file)
      throw InputError(filename, "", "the file cannot be written",
                       "check that the directory exists and has space left");
  }
} // namespace semilunar::spline
