// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/json/json.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <tuple>

#include "proofmass/core/error.hpp"

namespace proofmass {
namespace {

using Json = nlohmann::ordered_json;

Identification full_result() {
  Identification r;
  r.method = "pso-bp";
  r.model = "K0,Ki,Koq";
  r.seed = std::numeric_limits<std::uint64_t>::max();
  r.output_unit = *find_unit("mA");
  r.coefficients.resize(3);
  r.coefficients[0] = {.term = Term::K0,
                       .value = -0.0,
                       .standard_error = 0.1,
                       .ci95 = Interval{-0.2, 1.0 / 3},
                       .t = -0.0,
                       .p = 5e-324,
                       .vif = {},
                       .identified = true,
                       .reason = ""};
  r.coefficients[1] = {.term = Term::Ki,
                       .value = std::nextafter(1.3, 2.0),
                       .standard_error = 1e-9,
                       .ci95 = {},
                       .t = 1e300,
                       .p = 0.0,
                       .vif = 1.0,
                       .identified = true,
                       .reason = ""};
  r.coefficients[2] = {.term = Term::Koq,
                       .value = 0.0,
                       .standard_error = {},
                       .ci95 = {},
                       .t = {},
                       .p = {},
                       .vif = {},
                       .identified = false,
                       .left_out = true,
                       .reason = "confounded with \"Kii\": µ, [x] {y}, \\"};
  r.covariance = {0.01, 1e-11, 1e-11, 1e-18};
  r.network = TrainedNetwork{.inputs = {Axis::input, Axis::pendulous},
                             .hidden = 2,
                             .weights = {1, 2, 0.1, 4, 5, 6, 7, 8, std::nextafter(9.0, 10.0)},
                             .input_range = {{-1, 1}, {-20, 20.5}},
                             .output_range = {-3, 3}};
  r.train = Metrics{.n = 7, .mae = 0.1, .mse = 0.2, .rmse = std::sqrt(0.2), .mape_percent = {}, .r2 = 0.999};
  r.test = Metrics{.n = 3, .mae = 1, .mse = 2, .rmse = 3, .mape_percent = 4, .r2 = {}};
  r.ending = {.status = EndingStatus::early_stopped, .reason = "6 failures"};
  r.history = {{.name = "training", .values = {1.0, 0.1}}, {.name = "empty", .values = {}}};
  r.diagnostics.residual_sd = 0.3;
  r.diagnostics.dof = 4;
  r.diagnostics.saturated_share = 0.0;
  r.diagnostics.iterations = 4050;
  r.diagnostics.training_epochs = 1000;
  r.diagnostics.models_tried = 7;
  r.diagnostics.robust_scale = 0.25;
  r.diagnostics.optimum_rmse_ratio = 1.125;
  r.diagnostics.optimum_distance = 0.1;
  r.diagnostics.hidden_search = {{.hidden = 3,
                                  .weights = 16,
                                  .validation_rmse = {0.5, 0.25},
                                  .mean = 0.375,
                                  .best = 0.25,
                                  .spread = 0.125,
                                  .chosen = true}};
  r.diagnostics.suspect_rows = {
      {.row = 3, .line = 7, .residual = 0.1, .scaled_residual = 4.5, .weight = 0.0},
      {.row = 4, .line = std::nullopt, .residual = -0.3, .scaled_residual = -4.1, .weight = 0.5}};
  r.diagnostics.notes = {"a note"};
  r.provenance = {
      .version = "0.1.0", .input = "a.csv", .input_sha256 = "ff", .options = {{"b", "2"}, {"a", "1"}}};
  return r;
}

std::string message_of(const std::string& text) {
  try {
    (void)parse_result(text, "r.json");
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_data);
    return error.what();
  }
  return "no error";
}

TEST(Json, WritesTheSchemaOfTheContract) {
  const Json json = Json::parse(to_json(full_result()));
  EXPECT_EQ(json["schema"], "proofmass.identification/1");
  EXPECT_EQ(json["units"], Json::parse(R"({"acceleration":"g","output":"mA"})"));
  EXPECT_EQ(json["coefficients"][1]["unit"], "mA/g");
  EXPECT_EQ(json["coefficients"][2]["unit"], "mA/g^2");
  EXPECT_FALSE(json["coefficients"][2].contains("value"));
  EXPECT_EQ(json["coefficients"][0]["ci95"], Json::parse("[-0.2, 0.3333333333333333]"));
  EXPECT_FALSE(json["metrics"].contains("validation"));
  EXPECT_FALSE(json["metrics"]["test"].contains("r2"));
  EXPECT_EQ(json["input_referred"][0]["unit"], "g");
  EXPECT_EQ(json["covariance"].size(), 2U);
  EXPECT_EQ(json["ending"]["status"], "early_stopped");
}

TEST(Json, ReadsBackWhatItWroteToTheLastBit) {
  const Identification written = full_result();
  const std::string text = to_json(written);
  const Identification read = parse_result(text, "r.json");
  EXPECT_EQ(to_json(read), text);
  EXPECT_EQ(read.seed, written.seed);
  EXPECT_TRUE(std::signbit(read.coefficients[0].value));
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_EQ(read.coefficients[k].value, written.coefficients[k].value);
    EXPECT_EQ(read.coefficients[k].p, written.coefficients[k].p);
  }
  EXPECT_TRUE(read.coefficients[2].left_out);
  EXPECT_EQ(read.coefficients[2].reason, written.coefficients[2].reason);
  EXPECT_EQ(read.covariance, written.covariance);
  EXPECT_EQ(read.network->weights, written.network->weights);
  EXPECT_EQ(read.network->inputs, written.network->inputs);
  EXPECT_EQ(read.history[0].values, written.history[0].values);
  EXPECT_EQ(read.diagnostics.notes, written.diagnostics.notes);
  EXPECT_EQ(read.diagnostics.robust_scale, written.diagnostics.robust_scale);
  EXPECT_EQ(read.diagnostics.iterations, written.diagnostics.iterations);
  EXPECT_EQ(read.diagnostics.optimum_rmse_ratio, written.diagnostics.optimum_rmse_ratio);
  EXPECT_EQ(read.diagnostics.optimum_distance, written.diagnostics.optimum_distance);
  ASSERT_EQ(read.diagnostics.hidden_search.size(), 1U);
  const auto all_of = [](const HiddenTrial& t) {
    return std::tie(t.hidden, t.weights, t.validation_rmse, t.mean, t.best, t.spread, t.chosen);
  };
  EXPECT_EQ(all_of(read.diagnostics.hidden_search[0]), all_of(written.diagnostics.hidden_search[0]));
  ASSERT_EQ(read.diagnostics.suspect_rows.size(), 2U);
  for (std::size_t k = 0; k < 2; ++k) {
    const SuspectRow& a = read.diagnostics.suspect_rows[k];
    const SuspectRow& b = written.diagnostics.suspect_rows[k];
    EXPECT_EQ(std::tie(a.row, a.line, a.residual, a.scaled_residual, a.weight),
              std::tie(b.row, b.line, b.residual, b.scaled_residual, b.weight));
  }
  EXPECT_EQ(read.provenance.options, written.provenance.options);
  const Acceleration a{.i = 7.1, .o = -3.3, .p = 0.7};
  EXPECT_EQ(read.static_model().output(a), written.static_model().output(a));
}

RC_GTEST_PROP(Json, KeepsTheBitsOfEveryFiniteNumber, ()) {
  const auto bits = *rc::gen::arbitrary<std::uint64_t>();
  const auto value = std::bit_cast<double>(bits);
  RC_PRE(std::isfinite(value));
  Identification result = full_result();
  result.coefficients[0].value = value;
  const double read = parse_result(to_json(result), "r.json").coefficients[0].value;
  RC_ASSERT(std::bit_cast<std::uint64_t>(read) == bits);
}

TEST(Json, LeavesOutFiguresThatAreNotFinite) {
  Identification result = full_result();
  result.diagnostics.condition_raw = std::numeric_limits<double>::infinity();
  result.coefficients[0].vif = std::numeric_limits<double>::quiet_NaN();
  const Json json = Json::parse(to_json(result));
  EXPECT_FALSE(json["diagnostics"].contains("condition_raw"));
  EXPECT_FALSE(json["coefficients"][0].contains("vif"));
}

TEST(Json, NamesTheKeyThatIsWrong) {
  const Json good = Json::parse(to_json(full_result()));
  const auto broken = [&good](const char* pointer, const Json& value) {
    Json copy = good;
    copy[Json::json_pointer(pointer)] = value;
    return message_of(copy.dump());
  };
  EXPECT_EQ(broken("/schema", "proofmass.identification/2"),
            "r.json: key 'schema': found \"proofmass.identification/2\", expected "
            "\"proofmass.identification/1\"");
  EXPECT_EQ(broken("/coefficients/1/value", "x"),
            "r.json: key 'coefficients[1].value': found \"x\", expected a number");
  EXPECT_EQ(broken("/network/weights/3", nullptr),
            "r.json: key 'network.weights[3]': found null, expected a number");
  EXPECT_NE(broken("/network/hidden", 3).find("'network.weights'"), std::string::npos);
  EXPECT_NE(broken("/network/hidden", std::numeric_limits<std::uint64_t>::max()).find("'network.weights'"),
            std::string::npos);
  EXPECT_NE(broken("/coefficients/1/name", "K0").find("each term once"), std::string::npos);
  EXPECT_NE(broken("/seed", -1).find("'seed'"), std::string::npos);
  EXPECT_NE(broken("/covariance", Json::array({1})).find("'covariance'"), std::string::npos);
  EXPECT_NE(broken("/units/output", "furlong").find("'units.output'"), std::string::npos);
}

TEST(Json, NamesTheKeyThatIsMissing) {
  Json json = Json::parse(to_json(full_result()));
  json["metrics"]["test"].erase("rmse");
  EXPECT_EQ(message_of(json.dump()), "r.json: key 'metrics.test.rmse' is missing");
  EXPECT_EQ(message_of("{}"), "r.json: key 'schema' is missing");
}

TEST(Json, SaysWhereTextIsNotJson) {
  EXPECT_NE(message_of("{\"schema\": }").find("r.json: not JSON: parse error at line 1, column 12"),
            std::string::npos);
  EXPECT_NE(message_of("").find("not JSON"), std::string::npos);
  EXPECT_NE(message_of("[]").find("expected an object"), std::string::npos);
  EXPECT_NE(message_of("{\"schema\": 1e999}").find("not JSON"), std::string::npos);
}

TEST(Json, QuotesLongTextOnlyInPart) {
  const std::string junk(100'000, '7');
  const Json good = Json::parse(to_json(full_result()));
  Json long_key = good;
  long_key["history"] = {{junk, "x"}};
  Json long_text = good;
  long_text["seed"] = junk;
  for (const std::string& text : {junk, junk + "e", "\"" + junk, long_key.dump(), long_text.dump()}) {
    const std::string message = message_of(text);
    EXPECT_LT(message.size(), 300U);
    EXPECT_NE(message.find("777"), std::string::npos);
    EXPECT_NE(message.find("..."), std::string::npos);
  }
}

TEST(Json, RefusesFilesThatAreNotThere) {
  EXPECT_THROW((void)read_result("no/such/file.json"), Error);
  EXPECT_THROW((void)read_result("."), Error);
}

}  // namespace
}  // namespace proofmass
