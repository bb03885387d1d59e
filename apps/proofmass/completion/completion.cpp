// SPDX-License-Identifier: Apache-2.0
#include "completion/completion.hpp"

#include "proofmass/core/error.hpp"

namespace proofmass::cli {

std::string completion_script(const CLI::App& app, std::string_view shell) {
  if (shell == "bash") return bash_completion(app);
  if (shell == "zsh") return zsh_completion(app);
  if (shell == "fish") return fish_completion(app);
  throw usage_error(message("completion: found '{}', expected bash, zsh or fish", excerpt(shell)));
}

}  // namespace proofmass::cli
