// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/blas_threads.h>
#include <semilunar/core/exceptions.h>
#include <semilunar/core/version.h>
#include <semilunar/scene/run_scene.h>

#include <deal.II/base/mpi.h>

#include <iostream>

namespace
{
  using semilunar::CommandLine;

  enum ExitCode : int
  {
    done = 0,
    wrong_input = 1,
    numerics_gave_up = 2,
    internal_error = 3
  };

  bool is_first_rank()
  {
    return dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
  }

  void act(const CommandLine &command_line)
  {
    using Action = CommandLine::Action;
    if (command_line.action == Action::run)
      semilunar::scene::run_scene(command_line);
    else if (!is_first_rank())
      return;
    else if (command_line.action == Action::help)
      std::cout << semilunar::usage();
    else if (command_line.action == Action::version)
      std::cout << semilunar::version() << std::endl;
    else if (command_line.action == Action::list_scenes)
      semilunar::scene::list_scenes(std::cout);
    else
      semilunar::scene::print_scene_parameters(command_line.kind, command_line.format, std::cout);
  }

  int fail(const ExitCode code, const std::string &message)
  {
    if (is_first_rank())
      std::cerr << "error: " << message << std::endl;
    return code;
  }

  int run(const std::vector<std::string> &arguments)
  {
    try
    {
      act(CommandLine::parse(arguments));
      return done;
    }
    catch (const semilunar::InputError &error)
    {
      return fail(wrong_input, error.what());
    }
    catch (const semilunar::NumericsError &error)
    {
      return fail(numerics_gave_up, error.what());
    }
    catch (const std::exception &error)
    {
      return fail(internal_error, std::string("internal: ") + error.what());
    }
  }
} // namespace

int main(int argc, char *argv[])
{
  // As many threads as there are cores per rank, or fewer by DEAL_II_NUM_THREADS.
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv,
                                                     dealii::numbers::invalid_unsigned_int);
  semilunar::use_one_blas_thread();
  const int code = run({argv + 1, argv + argc});
  // An internal error may have hit this rank alone: do not leave the others waiting for it.
  if (code == internal_error && dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) > 1)
    MPI_Abort(MPI_COMM_WORLD, code);
  return code;
}
