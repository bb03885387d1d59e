// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <filesystem>
#include <utility>

#include "ours/tasks.hpp"
#include "proofmass/identify/method.hpp"
#include "proofmass/record/csv/csv.hpp"

namespace bench::ours {

// All 21 terms on columns Ai, Ao, Ap, E; the answer has the coefficients. Variants: ols, and wls with equal
// weights, so that the coefficients are equal too.
Answer least_squares(const Request& request) {
  std::vector<std::vector<double>> columns = read_columns(request.data, 4);
  proofmass::Dataset record;
  for (std::size_t axis = 0; axis < 3; ++axis) record.acceleration[axis] = std::move(columns[axis]);
  record.output = std::move(columns[3]);
  const proofmass::IdentifyOptions options{.terms = proofmass::full_terms()};
  const proofmass::Method method = proofmass::find_method(request.variant);
  if (request.variant == "wls") record.output_sigma.assign(record.rows(), 1e-6);
  proofmass::SilentProgress progress;
  proofmass::Identification result;
  Answer answer = measure(request.seconds, [&] { result = fit(method, record, {}, options, progress); });
  answer.ns = 1e9 * answer.seconds / static_cast<double>(record.rows());
  for (const proofmass::Coefficient& c : result.coefficients) answer.values.push_back(c.value);
  return answer;
}

// The answer has the number of rows and the mean square of E. A unit of work is a byte.
Answer read(const Request& request) {
  proofmass::Dataset record;
  Answer answer = measure(request.seconds, [&] { record = proofmass::read_record(request.data); });
  answer.ns = 1e9 * answer.seconds / static_cast<double>(std::filesystem::file_size(request.data));
  double sum = 0.0;
  for (const double e : record.output) sum += e * e;
  const auto rows = static_cast<double>(record.rows());
  answer.values = {rows, sum / rows};
  return answer;
}

}  // namespace bench::ours
