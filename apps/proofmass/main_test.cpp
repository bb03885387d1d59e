// SPDX-License-Identifier: Apache-2.0
// What every verb shares: help, usage errors, records that cannot be used.
#include "support/command_line.hpp"

namespace proofmass::test {
namespace {

class Program : public CommandLine {};

TEST_F(Program, HelpsAndNamesItsVersion) {
  for (const char* const verb : {"simulate", "identify", "compare", "reproduce", "predict", "inspect",
                                 "report", "completion", "manual", "help"}) {
    const Outcome help = proofmass({verb, "--help"});
    EXPECT_EQ(help.exit_code, 0);
    EXPECT_NE(help.out.find(std::string("Examples:\n  proofmass ") + verb), std::string::npos) << help.out;
    EXPECT_EQ(help.err, "");
    EXPECT_EQ(proofmass({"help", verb}).out, help.out);
  }
  const Outcome help = proofmass({"--help"});
  EXPECT_EQ(help.exit_code, 0);
  EXPECT_EQ(proofmass({}).out, help.out);
  EXPECT_EQ(proofmass({}).exit_code, 0);
  EXPECT_EQ(proofmass({"help"}).out, help.out);
  EXPECT_TRUE(proofmass({"--version"}).out.starts_with("proofmass "));
}

TEST_F(Program, ExitsWithTwoOnUsageErrors) {
  const std::string record = make_record();
  expect_failure(proofmass({"divine", record}), 2, {"unknown verb 'divine'", "identify"});
  expect_failure(proofmass({"identfy", record}), 2, {"did you mean identify?"});
  expect_failure(proofmass({"help", "identfy"}), 2, {"did you mean identify?"});
  expect_failure(proofmass({"complete"}), 2, {"completion, manual, help"});
  expect_failure(proofmass({"hlep"}), 2, {"did you mean help?"});
  expect_failure(proofmass({"completion"}), 2, {"SHELL", "proofmass completion --help"});
  expect_failure(proofmass({"manual", "identify", "more"}), 2, {"more", "proofmass manual --help"});
  expect_failure(proofmass({"identify", record, "--metod", "ols"}), 2,
                 {"--metod", "did you mean --method?", "proofmass identify --help"});
  expect_failure(proofmass({"identify", record, "--method", "pso_bp"}), 2, {"did you mean pso-bp?"});
  expect_failure(proofmass({"identify"}), 2, {"RUN.csv", "proofmass identify --help"});
  expect_failure(proofmass({"identify", record, "--frobnicate"}), 2, {"--frobnicate"});
  expect_failure(proofmass({"identify", record, "extra"}), 2, {"extra"});
  expect_failure(proofmass({"identify", record, "--method", "magic"}), 2, {"magic", "ols"});
  expect_failure(proofmass({"identify", record, "--model", "cubic"}), 2, {"--model", "'cubic'", "quadratic"});
  expect_failure(proofmass({"identify", record, "--terms", "K0,Kx"}), 2, {"Kx"});
  expect_failure(proofmass({"identify", record, "--terms", "K0", "--model", "full"}), 2,
                 {"--model and --terms both choose the terms: give one of them"});
  expect_failure(proofmass({"compare", record, "--methods", "ols", "--model", "full", "--terms", "K0"}), 2,
                 {"--model and --terms both choose the terms: give one of them"});
  expect_failure(proofmass({"identify", record, "--method", "bp", "--perturbations", "2", "--kicks", "1"}), 2,
                 {"--kicks is the former name of --perturbations: give one of them"});
  expect_failure(proofmass({"identify", record, "--validation-share", ".1", "--validation-fraction", ".1"}),
                 2, {"--validation-share is the former name of --validation-fraction: give one of them"});
  expect_failure(proofmass({"identify", record, "--split", "1.5"}), 2, {"--split", "'1.5'", "at most 1"});
  expect_failure(proofmass({"identify", record, "--split", "0.999"}), 2,
                 {"0.999 leaves none of 300 rows to test on", "try: --split 1 or --split 0.996"});
  expect_failure(proofmass({"identify", record, "--split", "nan"}), 2, {"--split", "'nan'"});
  expect_failure(proofmass({"identify", record, "--method", "bp", "--hidden", "0"}), 2,
                 {"--hidden", "'0'", "from 1 to 1000"});
  expect_failure(proofmass({"identify", record, "--method", "bp", "--hidden", "7.5"}), 2,
                 {"--hidden", "'7.5'"});
  expect_failure(proofmass({"identify", record, "--method", "pso-bp", "--inertia", "-1"}), 2,
                 {"--inertia", "'-1'"});
  expect_failure(proofmass({"identify", record, "--method", "bp", "--trainer", "sgd"}), 2,
                 {"--trainer", "'sgd'", "varpro, lm"});
  expect_failure(proofmass({"identify", record, "--method", "bp", "--preset", "other"}), 2,
                 {"--preset", "'other'"});
  // An option that the method does not take.
  expect_failure(proofmass({"identify", record, "--loss", "huber"}), 2,
                 {"--loss", "option of robust", "ols"});
  expect_failure(proofmass({"identify", record, "--method", "hybrid", "--trainer", "lm"}), 2,
                 {"--trainer", "bp, pso-bp", "hybrid"});
  expect_failure(proofmass({"identify", record, "--kicks", "1"}), 2, {"--kicks", "bp, pso-bp, hybrid"});
  expect_failure(proofmass({"identify", record, "--preset", "paper"}), 2, {"--preset", "bp, pso-bp"});
  expect_failure(proofmass({"compare", record, "--methods", "ols,wls", "--loss", "huber"}), 2,
                 {"--loss", "robust", "ols, wls do not"});
  expect_failure(proofmass({"identify", record, "--map", "Ai"}), 2, {"--map", "'Ai'"});
  expect_failure(proofmass({"identify", record, "--json", at("no/r.json")}), 2, {"no/r.json"});
  expect_failure(proofmass({"identify", record, "--out", record}), 2, {"--out", "not a folder"});
  EXPECT_EQ(names(), std::vector<std::string>{"run.csv"});
}

struct BadRecord {
  const char* what;
  std::string content;
  std::vector<std::string> parts;
};

TEST_F(Program, ExitsWithThreeOnBadRecordsAndNamesThePlace) {
  const std::vector<BadRecord> records{
      {"missing column", "Ai,Ao,Ap\n1,2,3\n", {"bad.csv:1", "'E'"}},
      {"not a number", "Ai,E\n1,1\n2,abc\n", {"bad.csv:3", "'E'", "abc"}},
      {"not finite", "Ai,E\n1,1\nnan,2\n", {"bad.csv:3", "'Ai'", "nan"}},
      {"ragged row", "Ai,E\n1,1\n2\n", {"bad.csv:3"}},
      {"empty file", "", {"bad.csv", "empty"}},
      {"no rows", "Ai,E\n", {"bad.csv"}},
      {"duplicate column", "Ai,Ai,E\n1,1,1\n", {"bad.csv:1", "'Ai'"}},
      {"unknown unit", "Ai[furlong],E\n1,1\n", {"bad.csv:1", "furlong"}},
      {"mixed units", "Ai[g],Ao[mg],E\n1,1,1\n", {"bad.csv:1", "mg"}},
      {"too few rows", "Ai,E\n1,1\n2,2\n", {"bad.csv", "2 rows", "at least 4"}},
      {"constant output", "Ai,E\n1,5\n2,5\n3,5\n4,5\n5,5\n6,5\n", {"bad.csv", "'E'", "5 in every row"}},
      {"binary junk",
       std::string("\x7f"
                   "ELF\0\x01\x02\n\0\xff",
                   10),
       {"bad.csv"}},
  };
  for (const BadRecord& record : records) {
    SCOPED_TRACE(record.what);
    const std::string path = write("bad.csv", record.content);
    expect_failure(proofmass({"identify", path, "--terms", "K0,Ki,Kii", "--split", "1", "--json",
                              at("r.json"), "--out", at("results")}),
                   3, record.parts);
    EXPECT_EQ(names(), std::vector<std::string>{"bad.csv"});
  }
  expect_failure(proofmass({"identify", at("none.csv")}), 3, {"none.csv"});
  expect_failure(proofmass({"inspect", at("")}), 3, {"directory"});
}

// What "try:" says can be pasted: it names columns that the file has, where they are few.
TEST_F(Program, NamesColumnsToPaste) {
  struct Case {
    std::string header;
    std::vector<std::string> flags;
    std::string remedy;
  };
  const std::vector<Case> cases{
      {"x,E", {}, "--map Ai=x"},
      {"x,y,E", {}, "--map Ai=x or --map Ai=y"},
      {"ax[g],E,out[V]", {}, "--map 'Ai=ax[g]'"},
      {"note,ax[g],ay[V],E", {}, "--map 'Ai=ax[g]'"},
      {"Ai,bob's", {}, "--map 'E=bob'\\''s'"},
      {"x,E,x", {}, "--map 'Ai=#1' or --map 'Ai=#3'"},
      {"a,b,c,d,E", {}, "--map Ai=NAME"},
      {"ax,out", {"--map", "Ai=ax"}, "--map E=out"},
      {"Ai,x,out", {"--map", "E=otu"}, "--map E=out"},
      {"AI,e", {}, "--map Ai=AI,E=e"},
  };
  for (const Case& one : cases) {
    std::vector<std::string> command{"inspect", write("run.csv", one.header + "\n1,2,3,4,5\n")};
    command.insert(command.end(), one.flags.begin(), one.flags.end());
    const Outcome outcome = proofmass(command);
    EXPECT_EQ(outcome.exit_code, 3);
    EXPECT_TRUE(outcome.err.ends_with("\ntry: " + one.remedy + "\n")) << one.header << ": " << outcome.err;
  }
}

}  // namespace
}  // namespace proofmass::test
