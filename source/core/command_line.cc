// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/command_line.h>
#include <semilunar/core/exceptions.h>
#include <semilunar/core/nearest_name.h>

#include <map>

namespace semilunar
{
  namespace
  {
    const std::vector<std::string> options = {
        "--set",   "--output", "--levels",  "--study",       "--dry-run",         "--restart",
        "--quiet", "--help",   "--version", "--list-scenes", "--print-parameters"};

    const std::map<std::string, ParameterFormat> formats = {
        {"prm", ParameterFormat::prm},
        {"json", ParameterFormat::json},
        {"markdown", ParameterFormat::markdown}};

    /// The arguments, taken one after the other.
    class Arguments
    {
    public:
      explicit Arguments(const std::vector<std::string> &arguments) : arguments(arguments) {}

      bool empty() const { return position == arguments.size(); }
      const std::string &peek() const { return arguments[position]; }
      const std::string &take() { return arguments[position++]; }

      const std::string &value_of(const std::string &option, const std::string &what)
      {
        if (empty() || peek().rfind("--", 0) == 0)
          throw InputError(option, "", what + " is missing", usage_hint);
        return take();
      }

      static constexpr const char *usage_hint = "--help prints how to call the program";

    private:
      const std::vector<std::string> &arguments;
      std::size_t position = 0;
    };

    void parse_print_parameters(Arguments &arguments, CommandLine &result)
    {
      result.action = CommandLine::Action::print_parameters;
      result.kind = arguments.value_of("--print-parameters", "the kind of scene");
      if (arguments.empty() || arguments.peek().rfind("--", 0) == 0)
        return;
      const std::string &format = arguments.take();
      if (formats.count(format) == 0)
        throw InputError("--print-parameters " + result.kind, format, "there is no such format",
                         "choose one of 'prm', 'json', 'markdown'");
      result.format = formats.at(format);
    }

    unsigned int parse_n_levels(Arguments &arguments)
    {
      const std::string &number = arguments.value_of("--levels", "the number of levels");
      if (number.size() != 1 || number[0] < '2' || number[0] > '9')
        throw InputError("--levels", number, "this is no number of levels",
                         "give a whole number from 2 to 9; three and more show the order");
      return number[0] - '0';
    }

    void parse_option(const std::string &option, Arguments &arguments, CommandLine &result)
    {
      if (option == "--set")
        result.overrides.push_back(arguments.value_of(option, "\"Section/Entry=value\""));
      else if (option == "--output")
        result.output_folder = arguments.value_of(option, "the folder");
      else if (option == "--levels")
        result.n_levels = parse_n_levels(arguments);
      else if (option == "--study")
        result.study = true;
      else if (option == "--dry-run")
        result.dry_run = true;
      else if (option == "--restart")
        result.restart = true;
      else if (option == "--quiet")
        result.quiet = true;
      else if (option == "--help")
        result.action = CommandLine::Action::help;
      else if (option == "--version")
        result.action = CommandLine::Action::version;
      else if (option == "--list-scenes")
        result.action = CommandLine::Action::list_scenes;
      else if (option == "--print-parameters")
        parse_print_parameters(arguments, result);
      else
        throw InputError(option, "", "there is no such option", suggest(option, options));
    }
  } // namespace

  CommandLine CommandLine::parse(const std::vector<std::string> &list)
  {
    CommandLine result;
    Arguments arguments(list);
    while (!arguments.empty())
    {
      const std::string argument = arguments.take();
      if (argument.size() > 1 && argument[0] == '-')
        parse_option(argument, arguments, result);
      else if (result.scene_file.empty())
        result.scene_file = argument;
      else
        throw InputError(argument, "", "there is a scene file already, " + result.scene_file,
                         "give one scene file; changed entries follow a --set");
    }
    if (result.restart && (result.dry_run || result.n_levels > 0 || result.study))
      throw InputError("--restart", "", "only a plain run can go on from a checkpoint",
                       "leave out --dry-run, --levels and --study");
    if (result.study && result.n_levels > 0)
      throw InputError("--study", "", "levels and variations do not go together",
                       "leave out one of --study and --levels");
    if (result.action == Action::run && result.scene_file.empty())
      throw InputError("command line", "", "there is no scene file", Arguments::usage_hint);
    return result;
  }

  std::string usage()
  {
    return R"(usage: semilunar SCENE.prm [options]

  --set "Section/Entry=value"  change an entry of the scene file (may be repeated)
  --output FOLDER              where to write (default: results/SCENE)
  --levels N                   run at N resolutions, each finer by what the scene's section Levels
                               says, and report speed against error
  --study                      run the scene, then with one entry changed at a time as its section
                               Study says, and report the quantities in a table
  --restart                    go on from the last checkpoint in the output folder
  --dry-run                    read and build everything, report sizes, compute and write nothing
  --quiet                      print nothing but errors

  --list-scenes                print the kinds of scenes and the scene files of each
  --print-parameters KIND [prm|json|markdown]
                               print all entries of a kind of scene with their documentation
  --version                    print versions and revision
  --help                       print this text

Exit codes: 0 done, 1 the input is wrong, 2 the numerics gave up, 3 internal error.
)";
  }
} // namespace semilunar
