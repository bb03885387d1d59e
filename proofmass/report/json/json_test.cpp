// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/json/json.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "proofmass/core/error.hpp"
#include "proofmass/report/json/comparison.hpp"
#include "proofmass/report/text/en.hpp"
#include "proofmass/report/text/endings.hpp"
#include "support/findings.hpp"

namespace proofmass {
namespace {

using Json = nlohmann::ordered_json;

Run full_run() {
  Run run;
  Identification& r = run.identification;
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
                       .reason = {}};
  r.coefficients[1] = {.term = Term::Ki,
                       .value = std::nextafter(1.3, 2.0),
                       .standard_error = 1e-9,
                       .ci95 = {},
                       .t = 1e300,
                       .p = 0.0,
                       .vif = 1.0,
                       .identified = true,
                       .reason = {}};
  r.coefficients[2] = {
      .term = Term::Koq,
      .value = 0.0,
      .standard_error = {},
      .ci95 = {},
      .t = {},
      .p = {},
      .vif = {},
      .identified = false,
      .left_out = true,
      .reason = Finding{
          .code = Code::term_left_out,
          .terms = {Term::Koq},
          .figures = {{"with", 1.0 / 3}, {"without", 0.25}, {"unit", std::string("\"µ\", [x] {y}, \\")}}}};
  r.input_range = {{Axis::input, {-1.0, 1.0}}, {Axis::pendulous, {-20.0, 20.5}}};
  r.covariance = {0.01, 1e-11, 1e-11, 1e-18};
  r.network = TrainedNetwork{.inputs = {Axis::input, Axis::pendulous},
                             .hidden = 2,
                             .weights = {1, 2, 0.1, 4, 5, 6, 7, 8, std::nextafter(9.0, 10.0)},
                             .input_range = {{-1, 1}, {-20, 20.5}},
                             .output_range = {-3, 3}};
  r.train = Metrics{.n = 7, .mae = 0.1, .mse = 0.2, .rmse = std::sqrt(0.2), .mape_percent = {}, .r2 = 0.999};
  r.test = Metrics{.n = 3, .mae = 1, .mse = 2, .rmse = 3, .mape_percent = 4, .mape_rows = 2, .r2 = {}};
  r.ending = {.status = EndingStatus::early_stopped,
              .parts = {{.code = EndingCode::best_candidate,
                         .figures = {{"epochs", 9.0}, {"candidates", 1.0}},
                         .parts = {{.code = EndingCode::validation_stalled, .figures = {{"epochs", 6.0}}}}}}};
  r.history = {{.name = "training", .values = {1.0, 0.1}}, {.name = "empty", .values = {}}};
  r.diagnostics.residual_sd = 0.3;
  r.diagnostics.dof = 4;
  r.diagnostics.r2_adjusted = 0.75;
  r.diagnostics.condition_raw = 1e7;
  r.diagnostics.condition_scaled = 12.5;
  r.diagnostics.iterations = 4050;
  r.details = NetworkDetails{.saturated_fraction = 0.0,
                             .induced_deviation = 1.0 / 7,
                             .training_epochs = 1000,
                             .swarm_evaluations = 3050,
                             .hidden_search = {{.hidden = 3,
                                                .weights = 16,
                                                .validation_rmse = {0.5, 0.25},
                                                .mean = 0.375,
                                                .best = 0.25,
                                                .spread = 0.125,
                                                .chosen = true}}};
  r.findings = {{.code = Code::expansion_differs, .terms = {Term::K0, Term::Koq}},
                {.code = Code::outlying_rows,
                 .severity = Severity::warning,
                 .lines = {7, 9},
                 .figures = {{"count", std::size_t{2}},
                             {"total", std::size_t{10}},
                             {"limit", 4.0},
                             {"scale", 1.0 / 3},
                             {"unit", std::string("mA")}}},
                {.code = Code::verbatim, .figures = {{"text", std::string("a note: µ, {x}, \"y\"")}}}};
  run.provenance = {.version = "0.2.0",
                    .input = "a.csv",
                    .input_sha256 = "ff",
                    .acceleration_unit = "m/s^2",
                    .options = {{"b", "2"}, {"a", "1"}},
                    .reading = {{.code = Code::record_units_assumed,
                                 .figures = {{"columns", std::string("Ai")}, {"unit", std::string("g")}}}}};
  return run;
}

Run with_details(Details details) {
  proofmass::Run run = full_run();
  run.identification.details = std::move(details);
  return run;
}

// As it comes back from its JSON.
Run again(const Run& run) { return parse_result(to_json(run), "r.json"); }

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
  const Json json = Json::parse(to_json(full_run()));
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
  EXPECT_FALSE(json.contains("split"));
  EXPECT_EQ(
      json["provenance"],
      Json::parse(
          R"({"version":"0.2.0","input":"a.csv","input_sha256":"ff","acceleration_unit":"m/s^2","options":{"b":"2","a":"1"},
          "reading":[{"code":"record_units_assumed","severity":"note","figures":{"columns":"Ai","unit":"g"},
          "text":"no unit is declared for Ai: g is assumed"}]})"));
  // The second name is that of 0.1.0.
  EXPECT_EQ(json["diagnostics"]["saturated_fraction"], 0.0);
  EXPECT_EQ(json["diagnostics"]["saturated_share"], 0.0);
}

TEST(Json, WritesFindingsAsDataAndAsSentences) {
  const Json json = Json::parse(to_json(full_run()));
  ASSERT_EQ(json["findings"].size(), 3U);
  const Json& differs = json["findings"][0];
  EXPECT_EQ(differs["code"], "expansion_differs");
  EXPECT_EQ(differs["severity"], "note");
  EXPECT_EQ(differs["terms"], Json::parse(R"(["K0","Koq"])"));
  EXPECT_FALSE(differs.contains("lines"));
  EXPECT_EQ(differs["figures"], Json::object());
  const Json& outlying = json["findings"][1];
  EXPECT_EQ(outlying["code"], "outlying_rows");
  EXPECT_EQ(outlying["severity"], "warning");
  EXPECT_FALSE(outlying.contains("terms"));
  EXPECT_EQ(outlying["lines"], Json::parse("[7, 9]"));
  EXPECT_EQ(outlying["figures"],
            (Json{{"count", 2.0}, {"total", 10.0}, {"limit", 4.0}, {"scale", 1.0 / 3}, {"unit", "mA"}}));
  // The notes of 0.1.0 are the same sentences.
  const std::vector<Finding> findings = full_run().identification.findings;
  const Json& notes = json["diagnostics"]["notes"];
  ASSERT_EQ(notes.size(), 3U);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(json["findings"][k]["text"], english(findings[k]));
    EXPECT_EQ(notes[k], english(findings[k]));
  }
  EXPECT_EQ(notes[2], "a note: µ, {x}, \"y\"");
}

TEST(Json, ReadsBackWhatItWroteToTheLastBit) {
  const auto run = full_run();
  const std::string text = to_json(run);
  const auto read_run = parse_result(text, "r.json");
  EXPECT_EQ(to_json(read_run), text);
  const Identification& written = run.identification;
  const Identification& read = read_run.identification;
  EXPECT_EQ(read.method, written.method);
  EXPECT_EQ(read.model, written.model);
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
  EXPECT_EQ(read.test->mape_rows, 2U);
  ASSERT_EQ(read.input_range.size(), 2U);
  EXPECT_EQ(read.input_range[1].first, Axis::pendulous);
  EXPECT_EQ(read.input_range[1].second.low, -20.0);
  EXPECT_EQ(read.input_range[1].second.high, 20.5);
  EXPECT_EQ(read.findings, written.findings);
  const auto figures_of = [](const Diagnostics& d) {
    return std::tie(d.residual_sd, d.dof, d.r2_adjusted, d.condition_raw, d.condition_scaled, d.iterations);
  };
  EXPECT_EQ(figures_of(read.diagnostics), figures_of(written.diagnostics));
  const Acceleration a{.i = 7.1, .o = -3.3, .p = 0.7};
  EXPECT_EQ(read.static_model().output(a), written.static_model().output(a));

  EXPECT_EQ(read_run.provenance.version, run.provenance.version);
  EXPECT_EQ(read_run.provenance.input, run.provenance.input);
  EXPECT_EQ(read_run.provenance.input_sha256, run.provenance.input_sha256);
  EXPECT_EQ(read_run.provenance.acceleration_unit, run.provenance.acceleration_unit);
  EXPECT_EQ(read_run.provenance.options, run.provenance.options);
}

TEST(Json, DoesNotKeepWhichRowsDidWhat) {
  auto run = full_run();
  const std::string without = to_json(run);
  run.split = {.training = {0, 2}, .validation = {3}, .test = {1}};
  EXPECT_EQ(to_json(run), without);
  const Split split = again(run).split;
  EXPECT_TRUE(split.training.empty() && split.validation.empty() && split.test.empty());
}

TEST(Json, ReadsBackTheDetailsOfANetwork) {
  const auto written = std::get<NetworkDetails>(full_run().identification.details);
  const auto read = std::get<NetworkDetails>(again(full_run()).identification.details);
  EXPECT_EQ(read.saturated_fraction, written.saturated_fraction);
  EXPECT_EQ(read.induced_deviation, written.induced_deviation);
  EXPECT_EQ(read.training_epochs, written.training_epochs);
  EXPECT_EQ(read.swarm_evaluations, written.swarm_evaluations);
  ASSERT_EQ(read.hidden_search.size(), 1U);
  const auto all_of = [](const HiddenTrial& t) {
    return std::tie(t.hidden, t.weights, t.validation_rmse, t.mean, t.best, t.spread, t.chosen);
  };
  EXPECT_EQ(all_of(read.hidden_search[0]), all_of(written.hidden_search[0]));
  // The least that a network tells.
  const auto least = std::get<NetworkDetails>(again(with_details(NetworkDetails{})).identification.details);
  EXPECT_FALSE(least.saturated_fraction || least.induced_deviation || least.swarm_evaluations);
  EXPECT_EQ(least.training_epochs, 0U);
  EXPECT_TRUE(least.hidden_search.empty());
}

TEST(Json, ReadsBackTheDetailsOfRobust) {
  const RobustDetails written{
      .scale = 0.25,
      .suspect_rows = {{.row = 3, .line = 7, .residual = 0.1, .scaled_residual = 4.5, .weight = 0.0},
                       {.row = 4, .line = {}, .residual = -0.3, .scaled_residual = -4.1, .weight = 0.5}}};
  const auto read = std::get<RobustDetails>(again(with_details(written)).identification.details);
  EXPECT_EQ(read.scale, 0.25);
  ASSERT_EQ(read.suspect_rows.size(), 2U);
  for (std::size_t k = 0; k < 2; ++k) {
    const SuspectRow& a = read.suspect_rows[k];
    const SuspectRow& b = written.suspect_rows[k];
    EXPECT_EQ(std::tie(a.row, a.line, a.residual, a.scaled_residual, a.weight),
              std::tie(b.row, b.line, b.residual, b.scaled_residual, b.weight));
  }
}

TEST(Json, ReadsBackTheDetailsOfTheOthers) {
  const auto gmdh = again(with_details(GmdhDetails{.models_tried = 7})).identification.details;
  EXPECT_EQ(std::get<GmdhDetails>(gmdh).models_tried, 7U);
  const AfsaDetails written{.swarm_evaluations = 4050, .optimum_rmse_ratio = 1.125, .optimum_distance = 0.1};
  const auto afsa = std::get<AfsaDetails>(again(with_details(written)).identification.details);
  EXPECT_EQ(afsa.swarm_evaluations, 4050U);
  EXPECT_EQ(afsa.optimum_rmse_ratio, 1.125);
  EXPECT_EQ(afsa.optimum_distance, 0.1);
  EXPECT_TRUE(
      std::holds_alternative<std::monostate>(again(with_details(std::monostate())).identification.details));
}

TEST(Json, KeepsWhatEndingsSay) {
  Ending ending{.status = EndingStatus::stalled,
                .parts = {{.code = EndingCode::particle_swarm,
                           .parts = {{.code = EndingCode::swarm_spent, .figures = {{"iterations", 60.0}}}}},
                          {.code = EndingCode::training,
                           .parts = {{.code = EndingCode::descent_stalled,
                                      .figures = {{"reduction", 1e-5}, {"epochs", 50.0}}},
                                     {.code = EndingCode::descent_polished, .figures = {{"steps", 2.0}}}}}}};
  proofmass::Run run = full_run();
  run.identification.ending = ending;
  std::string text = to_json(run);
  EXPECT_EQ(Json::parse(text)["ending"]["reason"],
            "swarm: all 60 iterations spent; training: less than 1e-05 relative reduction over 50 epochs; "
            "polished by 2 Gauss-Newton steps");
  EXPECT_EQ(parse_result(text, "a.json").identification.ending, ending);

  // The sentence alone, of a version that knows other codes.
  const std::string known = "\"descent_polished\"";
  text.replace(text.find(known), known.size(), "\"of_tomorrow\"");
  const Ending other = parse_result(text, "a.json").identification.ending;
  ASSERT_EQ(other.parts.size(), 1U);
  EXPECT_EQ(sentence(other.parts, Language::zh), sentence(ending.parts, Language::en));
}

// What 0.1.0 wrote for a network of one input: sentences instead of findings, and a share.
TEST(Json, ReadsResultsOfTheFirstVersion) {
  const std::string text =
      R"({"schema": "proofmass.identification/1", "method": "bp", "model": "K0,Ki", "seed": 3,
    "units": {"acceleration": "g", "output": "g"},
    "coefficients": [{"name": "K0", "value": 0.5, "standard_error": 0.1, "unit": "g", "identified": true},
                     {"name": "Ki", "value": 1.25, "unit": "g/g", "identified": true}],
    "metrics": {"train": {"n": 7, "mae": 0.1, "mse": 0.04, "rmse": 0.2}},
    "ending": {"status": "stalled", "reason": "no gain"},
    "history": {"training_rmse": [1.0, 0.2]},
    "diagnostics": {"residual_sd": 0.3, "dof": 4, "saturated_share": 0.25, "induced_deviation": 0.01,
                    "iterations": 9, "training_epochs": 9, "notes": ["one sentence", "and {another}: 5 %"]},
    "provenance": {"version": "0.1.0", "input": "a.csv", "input_sha256": "ff",
                   "options": {"method": "bp", "validation_share": "0.15"}},
    "network": {"inputs": ["Ai"], "hidden": 1, "weights": [1, 2, 3, 4], "input_range": [[-1, 1]],
                "output_range": [-2, 2]}})";
  const auto run = parse_result(text, "old.json");
  const Identification& result = run.identification;
  EXPECT_EQ(result.find(Term::Ki).value, 1.25);
  EXPECT_EQ(result.network->weights.size(), 4U);
  const auto& details = std::get<NetworkDetails>(result.details);
  EXPECT_EQ(details.saturated_fraction, 0.25);
  EXPECT_EQ(details.induced_deviation, 0.01);
  EXPECT_EQ(details.training_epochs, 9U);
  EXPECT_TRUE(result.input_range.empty());
  EXPECT_EQ(run.provenance.version, "0.1.0");
  EXPECT_EQ(run.provenance.options.at(1), (std::pair<std::string, std::string>("validation_share", "0.15")));

  ASSERT_EQ(result.findings.size(), 2U);
  for (const Finding& finding : result.findings) {
    EXPECT_EQ(finding.code, Code::verbatim);
    EXPECT_EQ(finding.severity, Severity::note);
  }
  const Json written = Json::parse(to_json(run));
  EXPECT_EQ(written["diagnostics"]["notes"], Json::parse(R"(["one sentence", "and {another}: 5 %"])"));
}

// A later version may find what this one has no word for.
TEST(Json, ReadsFindingsOfALaterVersionAsTheirSentences) {
  Json json = Json::parse(to_json(full_run()));
  json["findings"][1]["code"] = "clipped_output";
  json["findings"][1]["text"] = "31 rows are clipped";
  const auto run = parse_result(json.dump(), "new.json");
  const Finding& finding = run.identification.findings.at(1);
  EXPECT_EQ(finding.code, Code::verbatim);
  EXPECT_EQ(finding.severity, Severity::warning);
  EXPECT_EQ(english(finding), "31 rows are clipped");
}

TEST(Json, ComparisonsHaveTheFindingsOfRecordAndRuns) {
  Comparison comparison;
  Contestant contestant;
  contestant.method = "PSO-BP, ours";
  contestant.runs = {full_run(), full_run()};
  comparison.contestants = {std::move(contestant)};
  EXPECT_FALSE(Json::parse(to_json(comparison)).contains("findings"));
  comparison.findings = {
      {.code = Code::outputs_unlike_plan, .severity = Severity::warning, .figures = {{"ratio", 3.5}}}};
  const Json json = Json::parse(to_json(comparison));
  EXPECT_EQ(json["findings"][0]["code"], "outputs_unlike_plan");
  EXPECT_EQ(json["findings"][0]["figures"]["ratio"], 3.5);
  EXPECT_EQ(json["notes"], Json::array({english(comparison.findings[0])}));
  ASSERT_EQ(json["methods"][0]["runs"].size(), 2U);
  for (const Json& run : json["methods"][0]["runs"]) EXPECT_EQ(run, Json::parse(to_json(full_run())));
}

RC_GTEST_PROP(Json, KeepsTheBitsOfEveryFiniteNumber, ()) {
  const auto bits = *rc::gen::arbitrary<std::uint64_t>();
  const auto value = std::bit_cast<double>(bits);
  RC_PRE(std::isfinite(value));
  proofmass::Run run = full_run();
  run.identification.coefficients[0].value = value;
  run.identification.coefficients[0].ci95 = {.low = value, .high = value};
  run.identification.findings[1].figures[3].value = value;
  const Identification read = again(run).identification;
  RC_ASSERT(std::bit_cast<std::uint64_t>(read.coefficients[0].value) == bits);
  RC_ASSERT(std::bit_cast<std::uint64_t>(test::number(read.findings[1], "scale")) == bits);
}

TEST(Json, LeavesOutFiguresThatAreNotFinite) {
  auto run = full_run();
  Identification& result = run.identification;
  result.diagnostics.condition_raw = std::numeric_limits<double>::infinity();
  result.coefficients[0].vif = std::numeric_limits<double>::quiet_NaN();
  result.findings[1].figures[3].value = std::numeric_limits<double>::infinity();
  const Json json = Json::parse(to_json(run));
  EXPECT_FALSE(json["diagnostics"].contains("condition_raw"));
  EXPECT_FALSE(json["coefficients"][0].contains("vif"));
  EXPECT_EQ(json["findings"][1]["figures"]["scale"], "infinite");
  EXPECT_EQ(json["findings"][1]["text"], english(result.findings[1]));
  EXPECT_EQ(english(again(run).identification.findings[1]), english(result.findings[1]));
}

TEST(Json, NamesTheKeyThatIsWrong) {
  const Json good = Json::parse(to_json(full_run()));
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
  EXPECT_NE(broken("/coefficients/0/standard_error", -1.0).find("expected a number of at least 0"),
            std::string::npos);
  EXPECT_NE(broken("/coefficients/0/value", 1e3).find("an interval around the coefficient's value"),
            std::string::npos);
  EXPECT_NE(broken("/covariance", Json::array({1})).find("'covariance'"), std::string::npos);
  EXPECT_NE(broken("/units/output", "furlong").find("'units.output'"), std::string::npos);
  EXPECT_EQ(broken("/findings/1/severity", "grave"),
            "r.json: key 'findings[1].severity': found \"grave\", expected basis, note or warning");
  EXPECT_EQ(broken("/findings/0/terms/1", "Kxx"),
            "r.json: key 'findings[0].terms[1]': found \"Kxx\", expected the name of a term");
  EXPECT_NE(broken("/findings/1/lines/0", -1).find("'findings[1].lines[0]'"), std::string::npos);
  EXPECT_NE(broken("/findings/1/figures/limit", nullptr).find("'findings[1].figures.limit'"),
            std::string::npos);
}

TEST(Json, NamesTheKeyThatIsMissing) {
  Json json = Json::parse(to_json(full_run()));
  json["metrics"]["test"].erase("rmse");
  EXPECT_EQ(message_of(json.dump()), "r.json: key 'metrics.test.rmse' is missing");
  json = Json::parse(to_json(full_run()));
  json["findings"][2].erase("code");
  EXPECT_EQ(message_of(json.dump()), "r.json: key 'findings[2].code' is missing");
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
  const Json good = Json::parse(to_json(full_run()));
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
