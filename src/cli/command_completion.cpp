// `tiltrotor completion bash`: a script that completes commands, options and values.

#include "cli/command.hpp"
#include "cli/completion_script.hpp"
#include "cli/errors.hpp"
#include "text/sink.hpp"

namespace tiltrotor::cli {

namespace {

int run(const Arguments& arguments) {
  const bool zsh = arguments.choice("--shell", "bash", {"bash", "zsh"}) == 1;
  Sink sink("-", "");
  sink.write(zsh ? zsh_completion(all_commands()) : bash_completion(all_commands()));
  sink.finish();
  return exit_success;
}

}  // namespace

Command completion_command() {
  return {"completion",
          "a script for the shell that completes commands, options and values",
          "`tiltrotor completion bash` or `zsh`; for every shell to come:\n"
          "  echo 'source <(tiltrotor completion bash)' >> ~/.bashrc\n",
          "tiltrotor completion bash",
          {{"--shell", "SHELL", "bash or zsh (bash); the word alone will do"}},
          run};
}

}  // namespace tiltrotor::cli
