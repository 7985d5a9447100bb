// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/core/parameters.h>
#include <semilunar/mesh/parameters.h>

namespace semilunar::mesh
{
  namespace Patterns = dealii::Patterns;

  namespace
  {
    const std::map<std::string, Shape> shapes = {
        {"box", Shape::box},
        {"channel", Shape::channel},
        {"pipe", Shape::pipe},
        {"cylinder in channel", Shape::cylinder_in_channel},
        {"file", Shape::file},
        {"artery", Shape::artery},
        {"flag in channel", Shape::flag_in_channel}};

    void add_shape(dealii::ParameterHandler &prm, Shape &shape)
    {
      std::string names, name;
      for (const auto &[known, value] : shapes)
      {
        names += (names.empty() ? "" : "|") + known;
        if (value == shape)
          name = known;
      }
      prm.declare_entry(
          "Shape", name, Patterns::Selection(names),
          "What the mesh fills: a box (boundaries left, right, bottom, top, back, "
          "front), the same box as a channel along x (inlet, outlet, wall), the DFG "
          "benchmark's channel (inlet, outlet, wall, cylinder), the Turek-Hron benchmark's "
          "with an elastic flag (root, too, in two dimensions), a pipe or an artery "
          "along z (inlet, outlet, wall), or what a file holds.");
      prm.add_action("Shape", [&shape](const std::string &value) { shape = shapes.at(value); });
    }

    Patterns::List coordinates(const Patterns::PatternBase &pattern)
    {
      return Patterns::List(pattern, 2, 3);
    }

    void add_box(dealii::ParameterHandler &prm, BoxParameters &box)
    {
      prm.enter_subsection("Box");
      prm.add_parameter("Lower corner", box.lower, "Smallest coordinates [cm]",
                        coordinates(Patterns::Double()));
      prm.add_parameter("Upper corner", box.upper, "Largest coordinates [cm]",
                        coordinates(Patterns::Double()));
      prm.add_parameter("Cells", box.n_cells, "Cells in each direction",
                        coordinates(Patterns::Integer(1, 10000)));
      prm.leave_subsection();
    }

    void add_cylinder(dealii::ParameterHandler &prm, CylinderChannelParameters &cylinder)
    {
      prm.enter_subsection("Cylinder in channel");
      prm.add_parameter("Shell width", cylinder.shell_width,
                        "Width of the shells of cells around the cylinder, 0.005 to 0.045 [length]",
                        Patterns::Double(0.005, 0.045));
      prm.add_parameter("Shells", cylinder.n_shells, "Number of these shells",
                        Patterns::Integer(1, 50));
      prm.add_parameter("Skewness", cylinder.skewness,
                        "How much the shells cluster toward the cylinder; 0: not at all [-]",
                        Patterns::Double(0., 10.));
      prm.add_parameter("Cells deep", cylinder.n_cells_deep,
                        "Cells along the cylinder, in three dimensions", Patterns::Integer(1, 500));
      prm.leave_subsection();
    }

    void add_file(dealii::ParameterHandler &prm, FileParameters &file)
    {
      prm.enter_subsection("File");
      prm.add_parameter("Name", file.name,
                        "The file, in a format that deal.II tells by its ending (msh, ucd, inp, "
                        "vtk, vtu, unv, ...). Relative to the scene file, or to the current "
                        "directory if given by --set.",
                        Patterns::FileName());
      prm.add_parameter("Scale factor", file.scale, "All coordinates are multiplied by this [-]",
                        positive_number());
      prm.add_parameter("Boundaries", file.boundaries,
                        "Names of the boundary ids in the file, 'inlet: 1, outlet: 2'",
                        Patterns::Map(Patterns::Anything(), Patterns::Integer(0, 60000)));
      prm.leave_subsection();
    }
  } // namespace

  void MeshParameters::add_parameters(dealii::ParameterHandler &prm)
  {
    prm.enter_subsection("Mesh");
    add_shape(prm, shape);
    refinement.add_parameters(prm);
    add_box(prm, box);
    add_cylinder(prm, cylinder);
    prm.enter_subsection("Pipe");
    pipe.add_parameters(prm, false);
    prm.leave_subsection();
    prm.enter_subsection("Artery");
    artery.add_parameters(prm, true);
    prm.leave_subsection();
    add_file(prm, file);
    prm.leave_subsection();
  }

  void MeshParameters::check(const unsigned int dim) const
  {
    refinement.check(dim);
    if (dim == 2 && (shape == Shape::pipe || shape == Shape::artery))
      throw InputError("Mesh/Shape", shape == Shape::pipe ? "pipe" : "artery",
                       "a tube has three dimensions", "set Dimension = 3 or another shape");
    if (dim == 3 && shape == Shape::flag_in_channel)
      throw InputError("Mesh/Shape", "flag in channel", "this channel has two dimensions",
                       "set Dimension = 2 or another shape");
    if (shape == Shape::artery)
      artery.check("Mesh/Artery");
    if (shape == Shape::pipe)
      pipe.check("Mesh/Pipe");
    if (shape == Shape::file && file.name.empty())
      throw InputError("Mesh/File/Name", "", "the file is not named", "name the file of the mesh");
    if (shape != Shape::box && shape != Shape::channel)
      return;
    if (box.lower.size() < dim || box.upper.size() < dim || box.n_cells.size() < dim)
      throw InputError("Mesh/Box/Upper corner", "", "a coordinate is missing",
                       "give as many numbers as there are dimensions for corners and cells");
    for (unsigned int d = 0; d < dim; ++d)
      if (!(box.lower[d] < box.upper[d]))
        throw InputError("Mesh/Box/Upper corner", std::to_string(box.upper[d]),
                         "the upper corner lies below the lower one", "give larger coordinates");
  }
} // namespace semilunar::mesh
