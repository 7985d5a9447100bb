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
        {"flag in channel", Shape::flag_in_channel},
        {"flag", Shape::flag},
        {"blocks", Shape::blocks}};

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
          "with an elastic flag (root, too, in two dimensions), that flag alone (root, sides), "
          "a pipe or an artery along z (inlet, outlet, wall), blocks of lumen and wall in the "
          "plane (left, right, bottom, top; wall_left, ...), or what a file holds.");
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

    void add_blocks(dealii::ParameterHandler &prm, BlocksParameters &blocks)
    {
      prm.enter_subsection("Blocks");
      const Patterns::List numbers(Patterns::Double(), 2), counts(Patterns::Integer(1, 10000), 1);
      prm.add_parameter("x", blocks.x,
                        "Coordinates of the corners of blocks, increasing [cm]; radii if polar",
                        numbers);
      prm.add_parameter("y", blocks.y,
                        "Coordinates of the corners of blocks, increasing [cm]; angles if polar "
                        "[degrees]",
                        numbers);
      prm.add_parameter("Cells x", blocks.n_cells_x, "Equal cells between each two of them",
                        counts);
      prm.add_parameter("Cells y", blocks.n_cells_y, "Equal cells between each two of them",
                        counts);
      prm.add_parameter("Materials", blocks.materials,
                        "What each block consists of: lumen, wall or none; rows of words, divided "
                        "by semicolons, the row with the smallest y first");
      prm.add_parameter("Polar", blocks.polar, "Blocks of a ring around the origin");
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
    add_blocks(prm, blocks);
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
    if (dim == 3 &&
        (shape == Shape::flag_in_channel || shape == Shape::flag || shape == Shape::blocks))
      throw InputError("Mesh/Shape", "", "this shape has two dimensions",
                       "set Dimension = 2 or another shape");
    if (shape == Shape::blocks)
      blocks.check();
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
