// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/terminal/terminal_words.hpp"

#include <fmt/format.h>

#include "proofmass/core/text.hpp"

namespace proofmass {

Words severity_words(Severity severity) noexcept {
  switch (severity) {
    case Severity::warning:
      return {"warning: ", "警告："};
    case Severity::note:
      return {"note: ", "说明："};
    case Severity::basis:
      return {"basis: ", "依据："};
  }
  return {};
}

Words status_words(EndingStatus status) noexcept {
  switch (status) {
    case EndingStatus::direct:
      return {"direct", "直接求解"};
    case EndingStatus::converged:
      return {"converged", "收敛"};
    case EndingStatus::target_reached:
      return {"target_reached", "达到目标"};
    case EndingStatus::stalled:
      return {"stalled", "停滞"};
    case EndingStatus::early_stopped:
      return {"early_stopped", "提前停止"};
    case EndingStatus::iteration_limit:
      return {"iteration_limit", "达到迭代上限"};
    case EndingStatus::failed:
      return {"failed", "失败"};
  }
  return {};
}

std::string amount(std::size_t count, const Words& noun, Language language) {
  return language == Language::zh ? fmt::format("{} {}", count, noun.zh) : amount_text(count, noun.en);
}

std::vector<std::string> header_in(Language language, std::initializer_list<Words> names) {
  std::vector<std::string> header;
  for (const Words& name : names) header.emplace_back(name.in(language));
  return header;
}

}  // namespace proofmass
