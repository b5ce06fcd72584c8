"""The belts that the chute stands between, and chute.yaml: belts, inlet, domain, outlets, gauges, counts of clumps."""

import math

from chute import GRAVITY, Stream, before

# The inlet: mm behind the beginning of the feed belt and above it, and how fast the ore comes along it and down.
INLET_FROM, INLET_TO, INLET_LOW, INLET_HIGH = 100.0, 400.0, 60.0, 140.0
INLET_ALONG, INLET_DOWN = 1.0, 0.5  # m/s
RUBBER = 0.6  # friction of ore on a belt, in the cases
WRAP = 200.0  # degrees that the feed belt goes round its pulley; then back for two radii
FREE_FEED, FREE_RECEIVING = 200.0, 600.0  # mm at the end of a belt without skirts
OUTLET_FROM, OUTLET_TO = 150.0, 50.0  # mm before the end of the receiving belt


class Belts:
    """The belts that a chute stands between [mm], and whether it can."""

    def __init__(self, chute, mesh, given):
        self.given, self.chute = given, chute
        self.end = given.receiving_from + given.receiving_length
        self.lands = 1000 * chute.stations[-1][1].x
        self.check_pulley(1000 * mesh.low[0])
        self.check_widths()
        self.check_landing()
        self.check_start()
        half = max(given.feed_width, given.receiving_width, given.width) / 2 + 50
        drop = given.top - 2 * given.pulley_radius - given.receiving
        self.carried = given.receiving + drop / 8, given.receiving + 5 * drop / 8  # height of that outlet
        begins = min(-given.feed_length - 200, given.receiving_from - 200, round(self.carried_to()) - 50)
        self.low = (begins, -half, given.receiving - 300)
        self.high = (self.end - OUTLET_TO, half, max(given.top + 400, 1000 * mesh.high[1] + 50))

    def check_pulley(self, begins):
        """Whether the stream leaves the pulley at its top, and the chute begins behind it."""
        given = self.given
        middle = given.pulley_radius + given.stream / 2
        if given.speed**2 < GRAVITY * middle / 1000:
            raise ValueError(f"--speed: {given.speed:g} m/s; at least {math.sqrt(GRAVITY * middle / 1000):.2f} m/s, or the stream goes "
                             "round the pulley and leaves it behind its top, where the layout begins: a faster belt, or less "
                             "--pulley-radius")
        if given.pulley_radius >= begins:
            raise ValueError(f"--pulley-radius: {given.pulley_radius:g} mm; the chute begins at {begins:.0f} mm and would stand in "
                             "the pulley: a larger --sides-from, or less --hood-lead, --spoon-up or --pulley-radius")
        if given.top - 2 * given.pulley_radius <= given.receiving:
            raise ValueError(f"--pulley-radius: {given.pulley_radius:g} mm; the feed belt has to go back above the receiving one: less than "
                             f"{(given.top - given.receiving) / 2:g} mm, half of what lies between --top and --receiving")
        if given.feed_length < 3 * given.pulley_radius:
            raise ValueError(f"--feed-length: {given.feed_length:g} mm; at least three times --pulley-radius, "
                             f"{3 * given.pulley_radius:g} mm: the belt goes back below by twice that radius")

    def check_widths(self):
        given = self.given
        if not given.stream_width <= given.feed_skirts <= given.feed_width:
            raise ValueError(f"--feed-skirts: {given.feed_skirts:g} mm; at least --stream-width, {given.stream_width:g} mm, and at most "
                             f"--feed-width, {given.feed_width:g} mm")
        if not given.width < given.receiving_skirts <= given.receiving_width:
            raise ValueError(f"--receiving-skirts: {given.receiving_skirts:g} mm; more than --width, {given.width:g} mm, for the chute stands "
                             f"between them, and at most --receiving-width, {given.receiving_width:g} mm")

    def check_landing(self):
        """Whether the stream meets the receiving belt between its skirts."""
        given = self.given
        if self.lands < given.receiving_from:
            raise ValueError(f"--receiving-from: {given.receiving_from:g} mm; the stream meets the receiving belt at {self.lands:.0f} mm: "
                             "less than that")
        if self.lands > self.end - FREE_RECEIVING:
            raise ValueError(f"--receiving-length: {given.receiving_length:g} mm; the stream meets the receiving belt at {self.lands:.0f} mm, "
                             f"and its skirts end at {self.end - FREE_RECEIVING:.0f} mm: at least "
                             f"{math.ceil(self.lands - given.receiving_from + FREE_RECEIVING)} mm")

    def check_start(self):
        """Whether the ore slides no more when it comes to the pulley."""
        given = self.given
        needed = 1000 * abs(given.speed**2 - INLET_ALONG**2) / (2 * RUBBER * GRAVITY)
        if needed > given.feed_length - INLET_TO:
            self.chute.warnings.append(
                f"--feed-length {given.feed_length:g} mm: ore that comes with {INLET_ALONG:g} m/s slides {needed:.0f} mm on a belt with the "
                f"friction {RUBBER:g} until it has {given.speed:g} m/s, and from the inlet to the pulley are "
                f"{given.feed_length - INLET_TO:.0f} mm: at least {math.ceil(needed + INLET_TO)} mm")

    def carried_to(self):
        """Where ore that stuck to the feed belt to the end of its way back has fallen to the bottom of its outlet."""
        given, radius = self.given, self.given.pulley_radius / 1000
        turn = math.radians(WRAP)
        end = Stream(radius * (math.sin(turn) + 2 * math.cos(turn)),
                     given.top / 1000 - radius * (1 - math.cos(turn) + 2 * math.sin(turn)), turn, given.speed, 1.0)
        return 1000 * end.drop(end.z - self.carried[0] / 1000).x

    def time(self):
        """Of a grain from inlet to outlet, which slides on the feed belt until it has its speed [s]."""
        given, stations = self.given, [at for _, at in self.chute.stations]
        gain = given.speed - INLET_ALONG
        fed = (given.feed_length - (INLET_FROM + INLET_TO) / 2) / 1000 / given.speed
        slid = gain * abs(gain) / (2 * RUBBER * GRAVITY * given.speed)
        flown = sum(self.chute.time(a, b) for a, b in zip(stations, stations[1:]))
        return fed + slid + flown + (self.end - OUTLET_FROM - self.lands) / 1000 / given.receiving_speed


def mm(value):
    return f"{value:.10g} mm"


def box(low, high):
    """A region between two corners [mm]."""
    return "{box: {min: [%s], max: [%s]}}" % tuple(", ".join(mm(value) for value in corner) for corner in (low, high))


def around(low, high, half):
    """A region between corners (x, z) to whole millimetres, across the chute."""
    return box((round(low[0]), -half, round(low[1])), (round(high[0]), half, round(high[1])))


def belts_text(belts, given):
    """Domain, inlet, belts and outlets."""
    start, pulley, top, receiving = -given.feed_length, given.pulley_radius, given.top, given.receiving
    half, out = belts.high[1], belts.end - OUTLET_FROM
    skirts = given.receiving_length - FREE_RECEIVING
    inlet = box((start + INLET_FROM, -given.stream_width / 2, top + INLET_LOW),
                (start + INLET_TO, given.stream_width / 2, top + INLET_HIGH))
    return f"""\
# Written by `geometry`: a chute laid out for its stream, the belts that it stands between, and where to look at them.
# Its keys have the dimensions (--help): call it again rather than change numbers here.
domain: {{min: [{', '.join(map(mm, belts.low))}], max: [{', '.join(map(mm, belts.high))}]}}
grains:
  0: # the first of the case's list: falls on the beginning of the feed belt
    inlet: {{mass_flow: {given.flow:.10g} t/h}}
    region: {inlet}
    velocity: [{INLET_ALONG:g} m/s, 0 m/s, {-INLET_DOWN:g} m/s]
walls:
  feed:
    material: rubber
    shapes:
      - belt:
          from: [{mm(start)}, 0 mm, {mm(top)}]
          runs: [{{length: {mm(given.feed_length)}}}]
          width: {mm(given.feed_width)}
          speed: {given.speed:.10g} m/s
          pulley: {{radius: {mm(pulley)}, wrap: {WRAP:g} deg, return: {mm(2 * pulley)}}}
          skirts: {{to: {mm(given.feed_length - FREE_FEED)}, distance: {mm(given.feed_skirts)}, gap: 2 mm, height: 150 mm, material: steel}}
  receiving:
    material: rubber
    shapes:
      - belt:
          from: [{mm(given.receiving_from)}, 0 mm, {mm(receiving)}]
          runs: [{{length: {mm(given.receiving_length)}}}]
          width: {mm(given.receiving_width)}
          facet: 20 mm # for the map of pressure
          speed: {given.receiving_speed:.10g} m/s
          skirts: {{to: {mm(skirts)}, distance: {mm(given.receiving_skirts)}, gap: 2 mm, height: 200 mm, material: steel}}
  chute:
    material: steel
    shapes:
      - mesh: {{file: chute.obj, unit: 1 mm}}
# Ore that leaves by the receiving belt is delivered; what falls from the feed belt on its way back is
# carried back; what leaves elsewhere is spilled.
outlets:
  delivered: {{region: {box((out, -half, receiving - 50), (belts.high[0], half, receiving + 400))}}}
  carried_back: {{spillage: true, region: {box((belts.low[0], -half, belts.carried[0]), (-pulley / 3, half, belts.carried[1]))}}}
"""


def gauges_text(belts, mesh, given):
    """Gauges of belts and chute, and clumps in the chute."""
    chute, stations = belts.chute, dict(belts.chute.stations)
    half, meets, off = given.width / 2, stations["meets the hood"], stations["leaves the hood"]
    before_hood = max(500 * meets.x, 1000 * meets.x - 90)
    beside = given.feed_width / 2 + 25
    belt = given.receiving_width / 2
    on, above = given.receiving - 50, given.receiving + 300
    load = belts.end - 400
    begin = before(chute.at_hood, chute.hood_start, given.hood_lead / 1000)[0]
    inside = around((1000 * begin, 1000 * mesh.low[1] + 20), (1000 * mesh.high[0] + 20, 1000 * mesh.high[1]), half)
    end = around((1000 * off.x - 80, 1000 * off.z - 60), (1000 * off.x + 80, 1000 * off.z), half)
    edge = (1000 * chute.plate[-1][0], 1000 * chute.plate[-1][1])
    exit_ = around((edge[0] - 30, edge[1] - 10), (edge[0] + 20, edge[1] + 150), half)
    return f"""\
gauges:
  head: # the stream behind the head pulley, up to the hood
    region: {around((0, min(given.top - 450, 1000 * meets.z - 100)), (before_hood, given.top + 200), beside)}
    direction: [1, 0, 0]
    trajectory: {{bins: 12}}
  receiving: # all of the receiving belt: what becomes of its power
    region: {box((given.receiving_from, -belt, on), (belts.end - OUTLET_FROM, belt, above))}
    direction: [1, 0, 0]
    belt: receiving
  load: # a slice of the load on it
    region: {box((load, -belt, on), (load + 20, belt, above))}
    direction: [1, 0, 0]
    profile: {{bins: 20}}
  hood: # below the hood's end
    region: {end}
    direction: [1, 0, 0]
  chute: # hood to spoon: what is in it, and whether it is blocked
    region: {inside}
    blocked: {{mass_above: {0.5 * chute.mass:.3g} kg, speed_below: 0.3 m/s, for: 0.3 s}}
  overfull: # the same, when it holds more than twice what the stream has there, however fast: a heap that a stream still falls on
    region: {inside}
    blocked: {{mass_above: {2 * chute.mass:.3g} kg, speed_below: 100 m/s, for: 0.3 s}}
  exit: # the lip of the spoon, against direction and speed of the receiving belt
    region: {exit_}
    direction: [1, 0, 0]
    belt: receiving
clumps:
  counts:
    chute: {{region: {inside}}}
    flight: {{region: {inside}, free: true}}
"""
