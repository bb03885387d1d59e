// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <tuple>

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/identification.hpp"
#include "proofmass/core/progress.hpp"
#include "proofmass/identify/options/field.hpp"
#include "proofmass/identify/options/identify_options.hpp"
#include "proofmass/identify/options/method_info.hpp"

namespace proofmass {

enum class GmdhForm { combi, mia };                            // terms of the model; a network of quadratics
enum class GmdhCriterion { press, regularity, unbiasedness };  // leave-one-out; checking rows; two halves
inline constexpr std::array kGmdhFormWords{Word<GmdhForm>{"combi", GmdhForm::combi},
                                           Word<GmdhForm>{"mia", GmdhForm::mia}};
inline constexpr std::array kGmdhCriterionWords{
    Word<GmdhCriterion>{"press", GmdhCriterion::press},
    Word<GmdhCriterion>{"regularity", GmdhCriterion::regularity},
    Word<GmdhCriterion>{"unbiasedness", GmdhCriterion::unbiasedness}};

// Group method of data handling (Ivakhnenko 1970; docs/gmdh.md): the structure is chosen by an external
// criterion. Form combi chooses terms of the static model and refits them by least squares on all training
// rows; terms it leaves out come back as not identified, with their reason. Form mia grows a network of
// quadratic neurons and expands it into the terms. The result predicts by the coefficients in both forms.
struct Gmdh {
  GmdhForm form = GmdhForm::combi;
  GmdhCriterion criterion = GmdhCriterion::press;
  double checking_fraction = 0.3;  // of the training rows; criterion regularity only
  double tolerance = 0.0;        // combi: the fewest terms whose criterion, as a root mean square, is within
                                 // this fraction of the least
  std::size_t beam = 8;          // combi: subsets of each size that the stepwise search carries on
  std::size_t models = 100'000;  // combi: models that the exhaustive search after it may compute
  std::size_t layers = 8;        // mia: at most
  std::size_t survivors = 10;    // mia: neurons of a layer that feed the next
  bool inputs_in_every_layer = true;  // mia: the inputs feed every layer beside the survivors
  double improvement = 0.01;  // mia: ends when a layer lowers the criterion by less than this fraction

  static constexpr MethodInfo info{.name = "gmdh",
                                   .summary = "terms or polynomial network chosen by an external criterion",
                                   .page = "gmdh.md"};
  static constexpr auto fields = std::tuple{
      field("gmdh-form", &Gmdh::form, "terms of the model, or layers of quadratics", kGmdhFormWords,
            {.place = "gmdh.md#combi"}),
      field("gmdh-criterion", &Gmdh::criterion,
            "errors at rows left out one by one, errors at checking rows, or how far the fits to two "
            "halves of the rows differ",
            kGmdhCriterionWords, {.place = "gmdh.md#external-criteria"}),
      field("gmdh-checking-fraction", &Gmdh::checking_fraction,
            "fraction of the training rows that criterion regularity checks on",
            Range<double>{.low = 0.0, .high = 1.0, .above_low = true, .below_high = true},
            {.place = "gmdh.md#external-criteria", .former = "gmdh-checking-share"}),
      field("gmdh-tolerance", &Gmdh::tolerance,
            "combi: take the fewest terms within this fraction of the least criterion", at_least(0.0),
            {.place = "gmdh.md#combi"}),
      field("gmdh-beam", &Gmdh::beam, "combi: subsets the stepwise search carries", whole(1, kMostMembers),
            {.place = "gmdh.md#combi"}),
      field("gmdh-models", &Gmdh::models, "combi: models of the exhaustive search at most; 0: stepwise alone",
            whole(0), {.place = "gmdh.md#combi"}),
      field("gmdh-layers", &Gmdh::layers, "mia: layers, at most", whole(1, kMostUnits),
            {.place = "gmdh.md#mia"}),
      field("gmdh-survivors", &Gmdh::survivors, "mia: neurons that feed the next layer", whole(2, kMostUnits),
            {.place = "gmdh.md#mia"}),
      field("gmdh-inputs", &Gmdh::inputs_in_every_layer, "mia: the inputs feed every layer", kSwitchWords,
            {.place = "gmdh.md#mia"}),
      field("gmdh-improvement", &Gmdh::improvement,
            "mia: end when a layer lowers the criterion by less than this fraction", below(0.0, 1.0),
            {.place = "gmdh.md#mia"})};
};

// Errors as fit in identify/method.hpp says.
[[nodiscard]] Identification fit(const Gmdh& method, const Dataset& training, const IdentifyOptions& options,
                                 Progress& progress);

}  // namespace proofmass
