"""The table that tells what became of the starts of an experiment."""
from pages import table
from runs import Statistics
from trials import OUTCOMES, causes_text, share_text


def outcome_table(title, trials, name_of):
    """A line for each name that `name_of` gives to trials, in their order."""
    names = list(dict.fromkeys(name_of(trial) for trial in trials))
    return table([title, "starts", *OUTCOMES, "right [%]", "announced after [s]", "silent because"], [
        [name, *figures_of([start for trial in trials if name_of(trial) == name for start in trial.starts()])]
        for name in names])


def figures_of(starts):
    outcomes = [start.outcome for start in starts]
    ages = [start.age for start in starts if start.outcome == "right"]
    return [len(starts), *[outcomes.count(outcome) for outcome in OUTCOMES],
            share_text(outcomes.count("right"), len(starts)), Statistics(ages).mean, causes_text(starts)]
