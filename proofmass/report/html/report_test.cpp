// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/html/report.hpp"

#include <gmock/gmock.h>

#include <string>

#include "proofmass/numeric/random.hpp"
#include "proofmass/pipeline.hpp"
#include "proofmass/report/html/page/assets.hpp"
#include "proofmass/report/html/page/findings.hpp"
#include "proofmass/report/text/label.hpp"
#include "support/text.hpp"

namespace proofmass {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr std::string_view kHostile = "</script><script>alert(1)</script>\"'><img src=x onerror=alert(1)>";

Dataset record_of(std::size_t rows) {
  RandomStream random(5, stream_id("report"));
  Dataset record;
  for (std::size_t k = 0; k < rows; ++k) {
    for (auto& axis : record.acceleration) axis.push_back(random.uniform(-10.0, 10.0));
    const double a = record.acceleration[0].back();
    record.output.push_back(1.001 * a + 1e-4 * a * a + 1e-5 * random.normal());
    record.mount.push_back(k % 2 == 0 ? "up" : "down");
    record.time.push_back(static_cast<double>(k));
    record.temperature.push_back(20.0 + random.normal());
  }
  record.source = "run.csv";
  record.source_sha256 = std::string(64, 'a');
  return record;
}

struct Made {
  Dataset record;
  Run run;
  RecordFigures figures;
  explicit Made(Dataset from, const Method& method = Ols{})
      : record(std::move(from)),
        run(identify(record, method, {.terms = {Term::K0, Term::Ki, Term::Kii}})),
        figures(record_figures(record, run.split, run.identification)) {}
  [[nodiscard]] std::string page(const ReportStyle& style = {}) const {
    return render_report(run, &figures, style);
  }
};

TEST(Report, HasEveryPartThatThereAreDataFor) {
  const std::string page = Made(record_of(60)).page({.date = "2026-11-28"});
  for (const char* id : {"verdict", "coefficients", "scores", "fit", "residuals", "distribution",
                         "nonlinearity", "correlations", "influence", "excitation", "ending", "settings"})
    EXPECT_EQ(test::occurrences(page, "<section id=\"" + std::string(id) + "\""), 1U) << id;
  for (const char* along : {"ai", "ao", "ap", "magnitude", "order", "time", "temperature", "mount"})
    EXPECT_EQ(test::occurrences(page, "id=\"figure-residuals-" + std::string(along) + "\""), 1U) << along;
  for (const char* absent : {"training", "test-rows"})
    EXPECT_THAT(page, Not(HasSubstr("<section id=\"" + std::string(absent)))) << absent;
  EXPECT_THAT(page, HasSubstr("2026-11-28"));
  EXPECT_THAT(page, HasSubstr(std::string(64, 'a')));
}

TEST(Report, HasTheFiguresOfTrainingOfANetwork) {
  const std::string page = Made(record_of(120), find_method("bp")).page();
  EXPECT_THAT(page, HasSubstr("id=\"figure-training\""));
  EXPECT_THAT(page, HasSubstr("id=\"figure-test-errors\""));
  EXPECT_THAT(page, Not(HasSubstr("<section id=\"influence\"")));
}

TEST(Report, AsksNoNetworkAndSaysSo) {
  const std::string page = Made(record_of(60)).page();
  EXPECT_THAT(page, HasSubstr("Content-Security-Policy\" content=\"default-src 'none';"));
  const std::string own = page.substr(0, page.find("<script"));
  EXPECT_THAT(own, Not(HasSubstr("http://")));
  EXPECT_THAT(own, Not(HasSubstr("https://")));
  EXPECT_THAT(own, Not(HasSubstr("@import")));
  const std::string still = Made(record_of(60)).page({.interactive = false});
  EXPECT_THAT(still, Not(HasSubstr("<script")));
  EXPECT_THAT(still, Not(HasSubstr("script-src")));
}

TEST(Report, EscapesWhateverARecordOrAResultSays) {
  Dataset record = record_of(60);
  record.source = kHostile;
  record.mount[3] = kHostile;
  record.time_unit.symbol = kHostile;
  record.output_unit = {.quantity = Quantity::voltage, .symbol = std::string(kHostile), .to_canonical = 1.0};
  Made made(std::move(record));
  made.run.identification.model = kHostile;
  made.run.identification.ending.parts = {{.figures = {{"text", std::string(kHostile)}}}};
  made.run.provenance.version = kHostile;
  made.run.provenance.options.emplace_back(kHostile, kHostile);
  made.run.provenance.reading.push_back(
      {.code = Code::verbatim, .figures = {{"text", std::string(kHostile)}}});
  made.run.identification.findings.push_back(made.run.provenance.reading.back());
  made.run.identification.history.push_back({std::string(kHostile), {1.0, 2.0}});
  for (const bool interactive : {false, true}) {
    const std::string page = made.page({.date = std::string(kHostile), .interactive = interactive});
    EXPECT_THAT(page, Not(HasSubstr("<img")));
    EXPECT_THAT(page, Not(HasSubstr("<script>alert")));
    EXPECT_EQ(test::occurrences(page, "</script>"), test::occurrences(page, "<script"));
  }
}

TEST(Report, BeginsInTheLanguageThatIsAskedForAndHasBoth) {
  const Made made(record_of(60));
  const std::string english = made.page();
  const std::string chinese = made.page({.language = Language::zh});
  EXPECT_THAT(english, HasSubstr("<html lang=\"en\">"));
  EXPECT_THAT(chinese, HasSubstr("<html lang=\"zh-CN\">"));
  EXPECT_THAT(chinese, HasSubstr("id=\"lang-zh\" aria-label=\"中文\" checked"));
  for (const std::string& page : {english, chinese}) {
    EXPECT_THAT(page, HasSubstr("残差与温度"));
    EXPECT_THAT(page, HasSubstr("Residuals against temperature"));
    EXPECT_THAT(page, HasSubstr("solved directly by normal equations"));
    EXPECT_THAT(page, HasSubstr("由双倍工作精度的正规方程直接求解"));
    EXPECT_THAT(page, HasSubstr("standard errors assume exact inputs and white output noise"));
    EXPECT_THAT(page, HasSubstr("标准误差假定输入准确，输出噪声为白噪声"));
  }
}

TEST(Report, SaysWhyFiguresOfRowsAreAbsent) {
  const Made made(record_of(60));
  const std::string page = render_report(
      made.run, nullptr, {}, text_of(Label::absent_not_found, {{"file", std::string("run.csv")}}));
  EXPECT_THAT(page, HasSubstr("Figures of rows are absent: the record run.csv is not where it was."));
  EXPECT_THAT(page, Not(HasSubstr("figure-residuals")));
  EXPECT_THAT(page, HasSubstr("figure-correlations"));
}

TEST(Report, ShowsAFindingBesideItsFigure) {
  Made made(record_of(60));
  made.run.identification.findings.push_back(
      {.code = Code::residuals_follow_temperature, .severity = Severity::warning});
  const std::string page = made.page();
  EXPECT_THAT(page, HasSubstr("class=\"verdict doubt\""));
  const std::size_t figure = page.find("id=\"figure-residuals-temperature\"");
  const std::size_t end = page.find("</figure>", figure);
  EXPECT_THAT(page.substr(figure, end - figure), HasSubstr("finding warning"));
}

// Every figure that a finding is shown beside is one that some report has.
TEST(Report, HasTheFiguresThatFindingsNameOrNone) {
  const std::string page = Made(record_of(60)).page();
  for (const Code code : all_codes()) {
    const std::string_view figure = html::figure_of({.code = code});
    if (figure.empty()) continue;
    EXPECT_THAT(page, HasSubstr("id=\"figure-" + std::string(figure) + "\"")) << to_string(code);
  }
}

}  // namespace
}  // namespace proofmass
