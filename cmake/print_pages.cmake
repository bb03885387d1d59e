# SPDX-License-Identifier: Apache-2.0
# Prints the manual pages and the completion of PROGRAM into FOLDER. The verbs are those that the program's own page
# refers to: nobody lists them a second time.
function(print_page file)
  execute_process(COMMAND ${PROGRAM} ${ARGN} OUTPUT_FILE ${FOLDER}/${file} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE ${FOLDER})
file(MAKE_DIRECTORY ${FOLDER})
foreach(shell bash zsh fish)
  print_page(completion.${shell} completion ${shell})
endforeach()
print_page(proofmass.1 manual)
file(STRINGS ${FOLDER}/proofmass.1 references REGEX "^\\.BR proofmass")
foreach(reference IN LISTS references)
  string(REGEX REPLACE "^\\.BR proofmass\\\\-([a-z]+) .*" "\\1" verb "${reference}")
  print_page(proofmass-${verb}.1 manual ${verb})
endforeach()
