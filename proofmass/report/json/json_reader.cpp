// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>

#include "proofmass/core/error.hpp"
#include "proofmass/files/text_file.hpp"
#include "proofmass/report/json/endings_internal.hpp"
#include "proofmass/report/json/findings_internal.hpp"
#include "proofmass/report/json/json.hpp"
#include "proofmass/report/json/node_internal.hpp"
#include "proofmass/report/json/parts_internal.hpp"

namespace proofmass {
namespace {

constexpr std::string_view kSchema = "proofmass.identification/1";

Unit unit_of(const JsonNode& node) {
  const auto unit = find_unit(node.text());
  if (!unit) node.fail("a known unit");
  return *unit;
}

Coefficient coefficient_of(const JsonNode& node) {
  const auto term = find_term(node.at("name").text());
  if (!term) node.at("name").fail("the name of a term");
  Coefficient coefficient;
  coefficient.term = *term;
  coefficient.identified = node.at("identified").flag();
  if (coefficient.identified) coefficient.value = node.at("value").number();
  if (const auto left_out = node.find("left_out")) coefficient.left_out = left_out->flag();
  coefficient.standard_error = optional_number(node, "standard_error");
  if (coefficient.standard_error.value_or(0.0) < 0.0)
    node.at("standard_error").fail("a number of at least 0");
  if (const auto ci95 = node.find("ci95")) {
    coefficient.ci95 = interval_of(*ci95);
    if (!(coefficient.ci95->low <= coefficient.value && coefficient.value <= coefficient.ci95->high))
      ci95->fail("an interval around the coefficient's value");
  }
  coefficient.t = optional_number(node, "t");
  coefficient.p = optional_number(node, "p");
  coefficient.vif = optional_number(node, "vif");
  const auto cause = node.find("cause");
  if (cause && find_code(cause->at("code").text())) {
    coefficient.reason = finding_of(*cause);
  } else if (const auto reason = node.find("reason")) {  // all that 0.1.0 wrote
    coefficient.reason = {.code = Code::verbatim, .figures = {{"text", reason->text()}}};
  }
  return coefficient;
}

std::vector<Coefficient> coefficients_of(const JsonNode& node) {
  std::vector<Coefficient> coefficients;
  for (const JsonNode& item : node.items()) {
    coefficients.push_back(coefficient_of(item));
    const auto same = [&](const Coefficient& c) { return c.term == coefficients.back().term; };
    if (std::count_if(coefficients.begin(), coefficients.end(), same) > 1) {
      item.at("name").fail("each term once");
    }
  }
  return coefficients;
}

std::vector<double> covariance_of(const JsonNode& node, std::size_t size) {
  const std::vector<JsonNode> rows = node.items();
  if (rows.size() != size)
    node.fail(message("{}, one an identified coefficient", amount_of(size, "row", "rows")));
  std::vector<double> flat;
  for (const JsonNode& row : rows) {
    const std::vector<double> values = row.numbers();
    if (values.size() != size) row.fail(amount_of(size, "number", "numbers"));
    flat.insert(flat.end(), values.begin(), values.end());
  }
  return flat;
}

// Earlier versions knew the model's alone.
CovarianceKind covariance_kind_of(const JsonNode& root) {
  const auto node = root.find("covariance_kind");
  if (!node) return CovarianceKind::model;
  const auto kind = find_covariance_kind(node->text());
  if (!kind) node->fail("model, hc3 or mount");
  return *kind;
}

std::optional<Metrics> metrics_of(const JsonNode& parts, const std::string& part) {
  const auto node = parts.find(part);
  if (!node) return std::nullopt;
  return Metrics{.n = node->at("n").count(),
                 .mae = node->at("mae").number(),
                 .mse = node->at("mse").number(),
                 .rmse = node->at("rmse").number(),
                 .mape_percent = optional_number(*node, "mape_percent"),
                 .mape_rows = optional_count(*node, "mape_rows").value_or(0),
                 .r2 = optional_number(*node, "r2")};
}

std::vector<Curve> history_of(const JsonNode& node) {
  std::vector<Curve> curves;
  for (const auto& [name, values] : node.members()) {
    Curve curve{.name = name, .values = {}};
    for (const JsonNode& value : values.items()) {
      curve.values.push_back(value.is_null() ? std::numeric_limits<double>::infinity() : value.number());
    }
    curves.push_back(std::move(curve));
  }
  return curves;
}

// Earlier results have sentences alone.
std::vector<Finding> all_findings_of(const JsonNode& root) {
  if (const auto findings = root.find("findings")) return findings_of(*findings);
  std::vector<Finding> findings;
  for (const JsonNode& note : root.at("diagnostics").at("notes").items()) {
    findings.push_back({.code = Code::verbatim, .figures = {{"text", note.text()}}});
  }
  return findings;
}

Provenance provenance_of(const JsonNode& node) {
  Provenance provenance{.version = node.at("version").text(),
                        .input = node.at("input").text(),
                        .input_sha256 = node.at("input_sha256").text(),
                        .options = {},
                        .reading = {}};
  if (const auto unit = node.find("acceleration_unit")) provenance.acceleration_unit = unit->text();
  if (const auto reading = node.find("reading")) provenance.reading = findings_of(*reading);
  for (const auto& [key, value] : node.at("options").members()) {
    provenance.options.emplace_back(key, value.text());
  }
  return provenance;
}

constexpr std::size_t kLongestComplaint = 159;             // characters of the parser's words
constexpr std::size_t kMostBytes = std::size_t{1} << 30U;  // of a result

// "[json.exception.…] parse error at line 1, column 2: …" with what was read last, however long.
Message parser_complaint(std::string_view words) {
  const std::size_t begin = words.find("] ");
  const std::string said =
      excerpt(begin == std::string_view::npos ? words : words.substr(begin + 2), kLongestComplaint);
  constexpr std::string_view kLine = "parse error at line ";
  constexpr std::string_view kColumn = ", column ";
  const std::size_t column = said.find(kColumn);
  const std::size_t end = said.find(": ", column);
  if (!said.starts_with(kLine) || end == std::string::npos) return Message::verbatim(said);
  return message("parse error at line {}, column {}: {}", said.substr(kLine.size(), column - kLine.size()),
                 said.substr(column + kColumn.size(), end - column - kColumn.size()), said.substr(end + 2));
}

}  // namespace

Run parse_result(std::string_view text, const std::string& source) {
  JsonNode::Json json;
  try {
    json = JsonNode::Json::parse(text.begin(), text.end());
  } catch (const JsonNode::Json::exception& error) {
    throw Error(ErrorKind::bad_data, message("{}: not JSON: {}", source, parser_complaint(error.what())));
  }
  const JsonNode root(json, source);
  if (root.at("schema").text() != kSchema)
    root.at("schema").fail(Message::verbatim(fmt::format("\"{}\"", kSchema)));
  Identification result{.method = root.at("method").text(),
                        .model = root.at("model").text(),
                        .seed = root.at("seed").count(),
                        .output_unit = unit_of(root.at("units").at("output")),
                        .coefficients = coefficients_of(root.at("coefficients")),
                        .input_range = {},
                        .covariance = {},
                        .network = std::nullopt,
                        .row_weights = {},
                        .train = metrics_of(root.at("metrics"), "train"),
                        .validation = metrics_of(root.at("metrics"), "validation"),
                        .test = metrics_of(root.at("metrics"), "test"),
                        .leave_one_out = metrics_of(root.at("metrics"), "leave_one_out"),
                        .leave_one_mount_out = metrics_of(root.at("metrics"), "leave_one_mount_out"),
                        .ending = ending_of(root.at("ending")),
                        .history = history_of(root.at("history")),
                        .diagnostics = diagnostics_of(root.at("diagnostics")),
                        .details = details_of(root.at("diagnostics")),
                        .findings = all_findings_of(root)};
  if (const auto ranges = root.find("input_range")) {
    for (const Axis axis : kAxes) {
      if (const auto range = ranges->find(std::string(axis_name(axis)))) {
        result.input_range.emplace_back(axis, interval_of(*range));
      }
    }
  }
  if (const auto network = root.find("network")) result.network = network_of(*network);
  if (const auto covariance = root.find("covariance")) {
    const auto identified = std::count_if(result.coefficients.begin(), result.coefficients.end(),
                                          [](const Coefficient& c) { return c.identified; });
    result.covariance = covariance_of(*covariance, static_cast<std::size_t>(identified));
    result.covariance_kind = covariance_kind_of(root);
  }
  return {
      .split = {}, .identification = std::move(result), .provenance = provenance_of(root.at("provenance"))};
}

Run read_result(const std::filesystem::path& path) {
  return parse_result(read_text_file(path, "a result file that can be read", kMostBytes),
                      path == "-" ? "standard input" : path.string());
}

}  // namespace proofmass
