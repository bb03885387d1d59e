// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/text/endings.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace proofmass {
namespace {

struct SaidEnding {
  EndingPart part;
  std::string text;
};

const EndingPart kWithin{.code = EndingCode::swarm_spent, .figures = {{"iterations", 9.0}}};

// Programs have read these from results since the first version.
const std::vector<SaidEnding>& said_endings() {
  using enum EndingCode;
  static const std::vector<SaidEnding> kAll{
      {{verbatim, {{"text", std::string("{no} gain")}}}, "{no} gain"},
      {{start_not_finite}, "the sum of squares at the start is not finite"},
      {{stopped_by_observer}, "stopped by the observer"},
      {{stopped_on_request}, "stopped on request"},
      {{distance_iterations_spent, {{"iterations", 200.0}, {"length", 0.00123}}},
       "the 200 iterations allowed are spent, the last step was 1.2e-03 standard deviations long"},
      {{distance_step_short, {{"length", 1.26e-11}, {"limit", 1e-10}}},
       "the last step was 1.3e-11 standard deviations long, at or below 1.0e-10"},
      {{distance_stands_still, {{"sum", 1234.5678}, {"length", 1e-4}, {"reduction", 1e-8}}},
       "the sum of squares 1234.57 no longer falls, and the step that remains, 1.0e-04 standard errors long, "
       "would lower it by 1.0e-08 only"},
      {{distance_no_step, {{"sum", 0.25}, {"damping", 1e16}}},
       "no step reduces the sum of squares 0.25 up to damping 1e+16"},
      {{distance_runs_away, {{"significance", 2.5}, {"sum", 12.0}}},
       "the coefficients grow without end, together 2.5e+00 standard errors from zero, while the sum of "
       "squares tends to 12: the inputs are too uncertain to tell how the output depends on them"},
      {{distance_other_start, {{"start", 2.0}, {"total", 5.0}}},
       "start 2 of 5 gave this, the best result: the first start ended elsewhere"},
      {{distance_local_minimum, {{"sum", 3.5}, {"beyond", 1.25}}},
       "this minimum is a local one: the sum of squares, 3.5 here, tends to 1.25 where the coefficients grow "
       "without end"},
      {{reweighting_converged, {{"count", 7.0}, {"step", 1e-13}}},
       "converged after 7 reweightings: the last moved no fitted value by more than 1.0e-13 of the scale"},
      {{reweighting_spent, {{"count", 1.0}, {"step", 0.5}}},
       "stopped at the limit of iterations after 1 reweightings: the last moved no fitted value by more than "
       "5.0e-01 of the scale"},
      {{variance_converged, {{"count", 3.0}, {"fraction", 0.0303493}, {"step", 0.0}}},
       "converged after 3 rounds: the growing fraction of the variance is 0.0303493 and moved by 0.0e+00"},
      {{variance_spent, {{"count", 3.0}, {"fraction", 1.0}, {"step", 0.1}}},
       "stopped at the limit of rounds after 3 rounds: the growing fraction of the variance is 1 and moved "
       "by "
       "1.0e-01"},
      {{swarm_at_target, {{"value", 0.121808}, {"target", 0.5}}},
       "best value 0.121808 is at or below the target 0.5"},
      {{swarm_stalled, {{"iterations", 1.0}}}, "no better value in 1 iterations"},
      {{swarm_spent, {{"iterations", 60.0}}}, "all 60 iterations spent"},
      {{descent_at_target, {{"sum", 1e-9}, {"target", 1e-8}}},
       "sum of squares 1e-09 is at or below the target 1e-08"},
      {{descent_stalled, {{"reduction", 1e-5}, {"epochs", 50.0}}},
       "less than 1e-05 relative reduction over 50 epochs"},
      {{descent_no_step, {{"damping", 1e10}}}, "no step reduces the sum of squares up to damping 1e+10"},
      {{descent_polished, {{"steps", 1.0}}}, "polished by 1 Gauss-Newton steps"},
      {{epochs_spent}, "the epochs allowed are spent"},
      {{gradient_small, {{"gradient", 0.4381}, {"limit", 1.0}}}, "gradient 0.438 is at or below 1"},
      {{residuals_orthogonal, {{"limit", 1e-7}}},
       "no column of the Jacobian has a cosine above 1e-07 with the residuals"},
      {{weights_perturbed, {{"count", 4.0}, {"idle", 2.0}}}, "4 perturbations, the last 2 without gain"},
      {{validation_stalled, {{"epochs", 1.0}}}, "validation error did not improve in 1 epoch"},
      {{layers_stalled, {{"layer", 2.0}, {"before", 0.0047471}, {"after", 0.0041}, {"percent", 50.0}}},
       "layer 2 lowers the criterion from 0.004747 to 0.0041, less than the 50 % asked for"},
      {{layers_spent, {{"layers", 8.0}}}, "all 8 layers are grown"},
      {{layers_without_pair, {{"layer", 3.0}}}, "no pair of layer 3 could be fitted"},
      {{normal_equations, {{"rows", 1e6}, {"count", 1.0}}},
       "solved directly by normal equations in twice the working precision: 1000000 rows, 1 coefficient"},
      {{weighted_normal_equations, {{"rows", 70.0}, {"count", 15.0}}},
       "solved directly by normal equations in twice the working precision: 70 weighted rows, 15 "
       "coefficients"},
      {{singular_values, {{"rows", 70.0}, {"count", 15.0}, {"gap", 1.1899}}},
       "solved directly by QR and SVD: 70 rows, 15 coefficients, gap of the singular values 1.19"},
      {{after_iterations, {{"iterations", 1.0}}, {kWithin}}, "after 1 iteration all 9 iterations spent"},
      {{subsets_searched, {{"count", 710.0}, {"total", 32767.0}}},
       "710 models computed of the 32767 there are"},
      {{subsets_proven}, "the bound rules out that any other is better"},
      {{subsets_not_proven}, "a better one may exist, for the search was not exhaustive"},
      {{fish_swarm, {}, {kWithin}}, "fish swarm: all 9 iterations spent"},
      {{evaluations, {{"count", 9728.0}}}, "9728 evaluations"},
      {{particle_swarm, {}, {kWithin}}, "swarm: all 9 iterations spent"},
      {{training, {}, {kWithin, {epochs_spent}}},
       "training: all 9 iterations spent; the epochs allowed are spent"},
      {{nothing_left, {}, {kWithin}}, "nothing is left to gain: all 9 iterations spent"},
      {{best_candidate, {{"epochs", 1.0}, {"candidates", 2.0}}, {kWithin}},
       "all 9 iterations spent (1 epoch of the best of 2 candidates)"},
      {{sizes_compared,
        {{"chosen", 1.0}},
        {{size_compared, {{"units", 0.0}, {"difference", 0.0}}},
         {size_compared, {{"units", 1.0}, {"difference", -12.34}}}}},
       "the Bayesian information criterion, less that without a network: 0 units 0.0, 1 unit -12.3; it is "
       "least with 1 hidden unit"},
      {{sizes_compared_to_limit,
        {{"chosen", 2.0}},
        {{size_compared, {{"units", 2.0}, {"difference", -1.0}}}}},
       "the Bayesian information criterion, less that without a network: 2 units -1.0; it is least with 2 "
       "hidden units, the most allowed, and more might lower it further"},
      {{size_compared, {{"units", 1.0}, {"difference", 14.58}}}, "1 unit 14.6"},
      {{network_kept, {{"ratio", 0.365811}}},
       "cross-validation keeps the network: rms error at rows left out 0.36581 times that without"},
      {{network_dropped, {{"ratio", 1.25}}},
       "cross-validation drops the network: rms error at rows left out 1.25 times that without"},
      {{network_not_judged}, "the network is dropped: too few rows for a cross-validation"},
      {{sizes_unfinished, {{"epochs", 1.0}, {"sizes", std::string("1, 2")}, {"units", 2.0}}},
       "training used all of its 1 epoch with 1, 2 hidden units"},
      {{units_suffice, {{"units", 7.0}, {"ratio", 1.0052}}},
       "7 hidden units: the residual is 1.005 times that of least squares"},
      {{units_added, {{"from", 7.0}, {"units", 9.0}, {"before", 1.3532}, {"after", 1.0006}}},
       "9 hidden units: with 7 the residual was 1.353 times that of least squares, with 9 it is 1.001 times"},
      {{units_in_vain, {{"from", 7.0}, {"units", 12.0}, {"before", 1.02}, {"after", 1.03}}},
       "7 hidden units: the residual is 1.020 times that of least squares, and with 12 it is no less"}};
  return kAll;
}

TEST(Endings, SayInEnglishWhatTheyAlwaysSaid) {
  std::vector<EndingCode> codes;
  for (const SaidEnding& one : said_endings()) {
    EXPECT_EQ(sentence(std::vector<EndingPart>{one.part}, Language::en), one.text);
    codes.push_back(one.part.code);
  }
  EXPECT_EQ(codes, all_ending_codes());
}

TEST(Endings, PutTheirListsIntoChinese) {
  const EndingPart sizes{.code = EndingCode::sizes_unfinished,
                         .figures = {{"epochs", 30.0}, {"sizes", std::string("1, 2, 3")}, {"units", 2.0}}};
  EXPECT_EQ(sentence(std::vector<EndingPart>{sizes}, Language::zh),
            "隐层单元为 1、2、3 个时，训练用完了全部 30 个轮次");
}

}  // namespace
}  // namespace proofmass
