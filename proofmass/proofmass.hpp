// SPDX-License-Identifier: Apache-2.0
// All that a program includes:
//
//   const Dataset record = read_record("run.csv");
//   const Run run = identify(record, PsoBp{.particles = 50}, {.terms = paper_terms(), .seed = 3});
//   std::cout << summary(run);
#pragma once

#include "proofmass/assess/inspection.hpp"
#include "proofmass/core/dataset.hpp"
#include "proofmass/core/error.hpp"
#include "proofmass/core/finding.hpp"
#include "proofmass/core/identification.hpp"
#include "proofmass/core/progress.hpp"
#include "proofmass/core/run.hpp"
#include "proofmass/core/version.hpp"
#include "proofmass/identify/method.hpp"
#include "proofmass/identify/method_options.hpp"
#include "proofmass/identify/network/presets.hpp"
#include "proofmass/numeric/parallel.hpp"
#include "proofmass/pipeline.hpp"
#include "proofmass/record/csv/csv.hpp"
#include "proofmass/record/csv/writer.hpp"
#include "proofmass/report/csv.hpp"
#include "proofmass/report/json/json.hpp"
#include "proofmass/report/terminal/terminal.hpp"
#include "proofmass/report/text/en.hpp"
#include "proofmass/report/text/messages/message_text.hpp"
#include "proofmass/stand/twin/simulation.hpp"
#include "proofmass/stand/twin/simulation_file.hpp"
#include "proofmass/study/compare.hpp"
#include "proofmass/study/truth.hpp"
