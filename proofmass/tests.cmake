# SPDX-License-Identifier: Apache-2.0
# The library's test programs, one a module, and which of their tests carry which label (proofmass_add_tests).

# Statistics over many repeats.
set(numeric_statistics SwarmConvergence.* NistNonlinearMean.* SeparablePerceptron.IsExactOnManySamples*)
set(identify_statistics
  *UnbiasedAndEfficient* *ReachesTheBound* *FromAnySeed *FromEverySeed
  PsoBpOnTheTwin.*
  GmdhCombi.WithoutNoise* GmdhCombi.TrueTerms* Tls.SaysThatItIsBiased*
  Hybrid.IsLeast* Hybrid.Predicts* Hybrid.DoesNot*)
set(study_statistics Reproduce.TheSwarmGains*)

# Several threads: the tests that were seen to start some, on two processors. Of those, ThreadSanitizer leaves out the
# ones whose parallel code these here run: the kernels by instruction set (GramMatrix runs the same loop), laws of one
# comparison more (the law of any threads runs every method), the paper's experiment (the methods' own tests), and how
# far a long run of PSO and back-propagation comes (the same law, and its shorter runs).
set(numeric_threads
  Parallel.* FishSwarm.* */Swarm.* SwarmMotion.* SubsetSearch.* GramMatrix.*
  NormalSolution.ResidualsAndLeverages* OrthogonalDistance.ThreadsChangeNothing)
set(identify_threads
  */Law.SameSeed* */Law.PredictAgrees* Bp.S* PsoBp.T* PsoBp.C* PsoBp.RefinesOne* PsoBp.E* PsoBp.S* Refine.*
  Fitness.DependsOnThePositionAlone Afsa.* GmdhCombi.* GmdhMia.* StaticOutputs.* Wls.ManyRows*)
set(record_threads ReadRecord.IsTheSame* ReadRecord.NamesTheFirst*)
set(assess_threads HiddenSearch.*)
set(pipeline_threads */Identify.*)

# Sources with helpers of one name in another file of their module.
set(numeric_alone
  linear/normal_solution_test.cpp network/separable_kernels_test.cpp network/variable_projection_test.cpp
  optimise/particle_swarm_convergence_test.cpp optimise/particle_swarm_test.cpp
  regression/growing_variance_test.cpp regression/robust_regression_test.cpp
  regression/total_least_squares_test.cpp)
list(TRANSFORM numeric_alone PREPEND numeric/)
set(identify_alone
  network/pso_bp_test.cpp network/swarm_fitness_test.cpp network/training/refinement_test.cpp
  network/training/trainer_test.cpp regression/tls_test.cpp regression/wls_test.cpp search/afsa_test.cpp
  search/gmdh_test.cpp)
list(TRANSFORM identify_alone PREPEND identify/)

foreach(module IN LISTS modules)
  file(GLOB_RECURSE module_tests CONFIGURE_DEPENDS ${module}/*_test.cpp)
  if(module_tests)
    proofmass_add_tests(${module}_tests SOURCES ${module_tests} STATISTICS ${${module}_statistics}
      THREADS ${${module}_threads} ALONE ${${module}_alone})
  endif()
endforeach()
file(GLOB pipeline_tests CONFIGURE_DEPENDS *_test.cpp)
proofmass_add_tests(pipeline_tests SOURCES ${pipeline_tests} THREADS ${pipeline_threads})
