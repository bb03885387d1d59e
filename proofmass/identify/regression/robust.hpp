// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <tuple>

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/identification.hpp"
#include "proofmass/core/progress.hpp"
#include "proofmass/identify/options/field.hpp"
#include "proofmass/identify/options/identify_options.hpp"
#include "proofmass/identify/options/method_info.hpp"
#include "proofmass/numeric/regression/robust_loss.hpp"

namespace proofmass {

inline constexpr std::array kLossWords{Word<LossKind>{"huber", LossKind::huber},
                                       Word<LossKind>{"bisquare", LossKind::bisquare},
                                       Word<LossKind>{"t", LossKind::student}};

inline constexpr std::array kDefaultTunings{kHuberTuning, kBisquareTuning};  // for the help

// M-estimation on the terms asked for (docs/robust.md): rows far from the rest lose weight, by the loss of
// Huber, of Tukey (bisquare) or of Student's t. The result lists the suspect rows, largest residual first.
struct Robust {
  LossKind loss = LossKind::bisquare;
  // Huber's k, Tukey's c, Student's degrees of freedom; absent: default_tuning, and for Student estimated.
  std::optional<double> tuning{};
  double outlier_limit = 4.0;    // robust scales beyond which a row is listed as suspect
  std::size_t iterations = 500;  // of reweighting in one round, at most

  static constexpr MethodInfo info{.name = "robust",
                                   .summary = "M-estimation that gives outliers little weight and lists them",
                                   .page = "robust.md",
                                   .training_fraction = 1.0};
  static constexpr auto fields = std::tuple{
      field("loss", &Robust::loss, "loss function", kLossWords, {.place = "robust.md#which-loss"}),
      field("tuning", &Robust::tuning,
            "constant of the loss: Huber's k (default {}), Tukey's c ({}), degrees of freedom of t "
            "(estimated)",
            between(1e-3, 1e6),
            {.place = "robust.md#which-loss", .absent = "default", .figures = kDefaultTunings}),
      field("outlier-limit", &Robust::outlier_limit, "robust scales beyond which a row is listed as suspect",
            above(0.0), {.place = "robust.md#suspect-rows"}),
      field("robust-iterations", &Robust::iterations, "iterations of reweighting, at most", whole(1),
            {.place = "robust.md#what-it-does"})};
};

// Errors as fit in identify/method.hpp says; a refusal too when the rows that keep weight do not identify the
// terms, or the residuals are such that standard errors mean nothing.
[[nodiscard]] Identification fit(const Robust& method, const Dataset& training,
                                 const IdentifyOptions& options, Progress& progress);

}  // namespace proofmass
