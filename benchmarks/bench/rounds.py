# SPDX-License-Identifier: Apache-2.0
"""Rounds in which every contestant runs once, so that a disturbance of the machine affects all of them."""
import statistics
import sys

from bench.contestants import Failed


def interleave(stable, contestants, rounds, task, **flags):
    """name -> answers, one per round. Contestants that are not installed, or fail, are named on stderr."""
    answers = {}
    for contestant in contestants:
        if contestant.available():
            answers[contestant.name] = []
        else:
            print(f"   left out, not there: {contestant.name}", file=sys.stderr)
    racing = [c for c in contestants if c.name in answers]
    for number in range(rounds):
        shift = number % len(racing)
        for contestant in racing[shift:] + racing[:shift]:
            if number < contestant.rounds and answers[contestant.name] is not None:
                try:
                    answers[contestant.name].append(stable.ask(contestant, task, **flags))
                except Failed as failure:
                    stable.failures.append(contestant.name)
                    print(f"   FAILED: {failure}", file=sys.stderr)
                    answers[contestant.name] = None
    return answers


def spread(numbers):
    return {"median": statistics.median(numbers), "low": min(numbers), "high": max(numbers)}


def summarise(answers, reference, key="ns"):
    """name -> median figure and its ratio to the reference's in the same round, with the spread of both."""
    base = [answer[key] for answer in answers[reference]]
    summary = {}
    for name, list_of_answers in answers.items():
        if list_of_answers is None:
            summary[name] = {"failed": True}
            continue
        figures = [answer[key] for answer in list_of_answers]
        summary[name] = {
            key: spread(figures),
            "ratio": spread([theirs / ours for theirs, ours in zip(figures, base)]),
            "rounds": len(figures),
            "about": list_of_answers[-1]["about"],
        }
    return summary
