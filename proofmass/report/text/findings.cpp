// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/text/findings.hpp"

#include "proofmass/report/text/en.hpp"
#include "proofmass/report/text/zh.hpp"

namespace proofmass {

std::string sentence(const Finding& finding, Language language) {
  return language == Language::zh ? chinese(finding) : english(finding);
}

std::string reason(const Finding& finding, Language language) {
  return language == Language::zh ? chinese_reason(finding) : english_reason(finding);
}

}  // namespace proofmass
