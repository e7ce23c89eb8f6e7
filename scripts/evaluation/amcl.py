"""amcl without a prior, through replay of the drives of the cold starts."""
import cold_starts
import office

RATE = 2.0  # times faster than driven, which amcl follows with so many particles
UNKNOWN = ("particles", "updates", "update_time")  # columns of Monte-Carlo localization that amcl does not tell
PARAMETERS = {"max_particles": 10000, "odom_alpha1": 0.01, "odom_alpha2": 0.001, "odom_alpha3": 0.003,
              "odom_alpha4": 0.0005}
SENTENCE = "amcl itself, with 10000 particles, the true noise of the odometry and its own defaults otherwise, got the " \
           "same drives through `replay_amcl.launch`; it is looked at whenever it has updated its particles, " \
           "and a start in which it never did, since the robot stood still, is not counted. " \
           "[amcl.csv](amcl.csv)"
LEFT_OUT = "amcl itself is left out; `--amcl` adds it where it is installed."


def plan(runs, arguments):
    """Runs by density and kind of scans."""
    config = runs.write_config("amcl", **PARAMETERS)
    map_file = office.map_file(runs, arguments)
    replays = {}
    for density, seed, simulation in cold_starts.simulations(arguments):
        name = "amcl_%g_%d" % (density, seed)
        bag = runs.path(name + ".bag")
        runs.add(name + "_bag", "simulate_drive", [*simulation, "--bag", bag], [bag])
        for variant in cold_starts.VARIANTS:
            scrub = "true" if variant == "scrubbed" else "false"
            replays.setdefault((density, variant), []).append(runs.replay(
                "amcl_%g_%s_%d" % (density, variant, seed), "replay_amcl.launch", bag, RATE, [
                    "map:=%s" % map_file, "config:=%s" % config, "interval:=%g" % cold_starts.INTERVAL,
                    "scrub:=" + scrub], ["amcl.csv"], phase=2))
    return replays
