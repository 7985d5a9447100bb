// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Scene files: what is read, and what is said about each kind of mistake (file and line, the value,
// what is allowed, the nearest name).

#include <semilunar/core/exceptions.h>
#include <semilunar/core/parameters.h>

#include <filesystem>
#include <sstream>

#include "../tests.h"

using namespace semilunar;
using tests::log;

namespace
{
  struct Material
  {
    double thickness = 0.04;
    unsigned int points = 4;
    std::string law = "Fung", file;
    std::vector<double> direction{1., 0., 0.};

    void add_parameters(dealii::ParameterHandler &prm)
    {
      prm.enter_subsection("Shell");
      prm.add_parameter("Thickness", thickness, "Thickness [cm].", positive_number());
      prm.enter_subsection("Material");
      prm.add_parameter("Law", law, "The law.", dealii::Patterns::Selection("Fung|neo-Hookean"));
      prm.add_parameter("Points", points, "Gauss points.", dealii::Patterns::Integer(1, 9));
      prm.add_parameter("Direction", direction, "Fibres.",
                        dealii::Patterns::List(dealii::Patterns::Double(), 3, 3));
      prm.add_parameter("File", file, "Data.", dealii::Patterns::FileName());
      prm.leave_subsection();
      prm.leave_subsection();
    }
  };

  Material read(const std::string &text, const std::vector<std::string> &overrides = {})
  {
    std::ofstream("scene.prm") << text;
    ParameterInput input = ParameterInput::read("scene.prm");
    for (const std::string &argument : overrides)
      input.override_with(argument);
    Material material;
    dealii::ParameterHandler prm;
    material.add_parameters(prm);
    assign(input, prm,
           [](const std::string &section)
           { return std::vector<std::string>(section == "Fluid" ? 1 : 0, "flow"); });
    return material;
  }

  void complain(const std::string &text, const std::vector<std::string> &overrides = {})
  {
    try
    {
      read(text, overrides);
      log() << "NO MESSAGE for " << text << std::endl;
      std::exit(1);
    }
    catch (const InputError &error)
    {
      log() << error.what() << std::endl;
    }
  }

  void good_files()
  {
    const std::string text = "# comment\r\n"
                             "subsection   Shell\n"
                             "  set Thickness = 2.5e-2 # cm\n"
                             "  subsection Material\n"
                             "    set Law=neo-Hookean\n"
                             "    set Direction = 0, \\ # continued\n"
                             "                    1, 0\n"
                             "    set File = data.txt\n"
                             "  end\n"
                             "end";
    Material material = read(text);
    log() << material.thickness << ' ' << material.law << ' ' << material.direction[1] << std::endl;
    log() << "file beside the scene file: "
          << (material.file == std::filesystem::absolute("data.txt")) << std::endl;
    material = read(text, {"Shell/Thickness=1", "Shell / Material/Points = 3"});
    log() << "overridden: " << material.thickness << ' ' << material.points << std::endl;
  }

  void mistakes_of_syntax()
  {
    complain("subsection Shell\nset Thickness = 1\n");
    complain("end\n");
    complain("subsection\nend\n");
    complain("subsection Shell\nend Shell\n");
    complain("Thickness = 1\n");
    complain("set Thickness 1\n");
    complain("set Thickness = 1 \\");
    complain(
        "subsection Shell\nset Thickness = 1\nend\nsubsection Shell\nset Thickness = 2\nend\n");
  }

  void mistakes_of_names_and_values()
  {
    complain("subsection Shell\nset Thicknes = 1\nend\n");
    complain("subsection Shell\nset Law = Fung\nend\n");
    complain("set xyz = 1\n");
    complain("subsection Schell\nend\n");
    complain("subsection Fluid\nend\n");
    complain("subsection Shell\nset Thickness = 0.04cm\nend\n");
    complain("subsection Shell\nset Thickness = nan\nend\n");
    complain("subsection Shell\nset Thickness = 0\nend\n");
    complain("subsection Shell\nset Thickness =\nend\n");
    complain("subsection Shell\nsubsection Material\nset Law = Funk\nend\nend\n");
    complain("subsection Shell\nsubsection Material\nset Points = 2.5\nend\nend\n");
    complain("subsection Shell\nsubsection Material\nset Direction = 1, 0\nend\nend\n");
    complain("", {"Shell/Material/Thickness=1"});
    complain("", {"Shell/Thickness"});
    complain("", {"Shell/Thickness=1", "Shell/Thickness=2"});
  }

  void included_files()
  {
    std::ofstream("base.prm")
        << "subsection Shell\nset Thickness = 1\nsubsection Material\nset Law = "
           "neo-Hookean\nend\nend\n";
    const Material material =
        read("# first\ninclude base.prm\nsubsection Shell\nset Thickness = 2\n"
             "end\n");
    log() << "included: " << material.thickness << ' ' << material.law << std::endl;
    complain("include base.prm\nsubsection Shell\nset Thickness = 2\nset Thickness = 3\nend\n");
    complain("subsection Shell\nend\ninclude base.prm\n");
    complain("include scene.prm\n");
    complain("include bas.prm\n");
    complain("include base.prm\nsubsection Shell\nset Thicknes = 3\nend\n");
  }

  /// A printed file is a valid one and gives the same values.
  void round_trip()
  {
    Material material = read("subsection Shell\nset Thickness = 0.1\nend\n");
    dealii::ParameterHandler prm;
    material.add_parameters(prm);
    std::ostringstream file;
    print_parameters(prm, ParameterFormat::prm, file);
    log() << "printed and read: " << read(file.str()).thickness << std::endl;
    print_parameters(prm, ParameterFormat::markdown, log());
  }
} // namespace

int main()
{
  good_files();
  mistakes_of_syntax();
  mistakes_of_names_and_values();
  included_files();
  round_trip();
}
