"""A stream of ore over hood and spoon by the closed forms of docs/theory/belts-and-chutes.md, and the plates that make it."""

import math

GRAVITY = 9.81
SEGMENT = 3.0  # degrees of a facet of an arc
LEAST = 0.2  # share of its speed that a hit must leave to a stream
# times the arc that takes up a stream: in one of 6 mm hoods of 6.6 times (--hood-to 75) worked, of 3.6 and 1.6 times (66, 60) not;
# in one of 25 mm (40 t/h) one of 3.5 times did (docs/results/transfer-chute.md)
ENOUGH, ENOUGH_THIN = 3.0, 6.0
THIN = 20.0  # mm, thickness of a stream
FAR = 3.0  # factor between --stream and what --flow makes
GRAIN = 6.35  # mm, diameter of a mean grain of the cases: no layer is thinner


class Stream:
    """The middle of a stream: place [m], angle below the horizontal [rad], speed [m/s]."""

    def __init__(self, x, z, angle, speed, thickness):
        self.x, self.z, self.angle, self.speed, self.thickness = x, z, angle, speed, thickness

    def beside(self, distance):
        """A place beside the middle, above the stream when the distance is positive."""
        return (self.x + distance * math.sin(self.angle), self.z + distance * math.cos(self.angle))

    def moved(self, along, up, angle, speed):
        return Stream(self.x + along, self.z + up, angle, speed,
                      self.thickness * self.speed / speed)

    def fall(self, time):
        along, down = self.speed * math.cos(self.angle), self.speed * math.sin(self.angle)
        after = down + GRAVITY * time
        return self.moved(along * time, -(down + after) * time / 2, math.atan2(after, along),
                          math.hypot(along, after))

    def drop(self, height):
        down = self.speed * math.sin(self.angle)
        return self.fall((math.sqrt(down * down + 2 * GRAVITY * height) - down) / GRAVITY)

    def hit(self, angle, friction):
        """On a plate at an angle: what goes along it stays, less friction on what is stopped."""
        off = abs(angle - self.angle)
        left = math.cos(off) - friction * math.sin(off)
        if left < LEAST:
            raise ValueError(f"a hit at {math.degrees(off):.0f} degrees leaves the stream {100 * left:.0f} % of "
                             "its speed: less --hood-hit, --spoon-behind or --friction")
        return self.moved(0, 0, angle, self.speed * left)

    def turn(self, radius, angle, friction, under):
        """Along a plate that turns: a hood, under which the stream goes, or a spoon."""
        steps = max(1, math.ceil(1000 * abs(angle - self.angle)))
        d = (angle - self.angle) / steps
        s = radius * abs(d)

        def gain(square, a):  # of the square of the speed, along s
            weight = GRAVITY * math.cos(a)
            press = max(0.0, square / radius + (-weight if under else weight))
            return 2 * s * (GRAVITY * math.sin(a) - friction * press)

        x, z, square, a = 0.0, 0.0, self.speed**2, self.angle
        for _ in range(steps):
            if under and square < radius * GRAVITY * math.cos(a):
                raise ValueError("the stream is too slow to follow the hood and falls from it: it would "
                                 f"take {math.sqrt(radius * GRAVITY * math.cos(a)):.2f} m/s; a smaller "
                                 "--hood-radius or more --hood-meets")
            half = square + gain(square, a) / 2
            square += gain(half, a + d / 2)
            if square <= 0:
                raise ValueError("the stream stops on a plate: less --friction, or a smaller --spoon-to")
            x, z = x + s * math.cos(a + d / 2), z - s * math.sin(a + d / 2)
            a += d
        return self.moved(x, z, angle, math.sqrt(square))


class Chute:
    """Stations of the stream, and the plates that make them."""

    def __init__(self, given):
        self.given = given
        half = given.stream / 2000
        leaves = Stream(0.0, given.top / 1000 + half, 0.0, given.speed, 2 * half)
        meets = leaves.fall(given.speed * math.tan(math.radians(given.hood_meets)) / GRAVITY)
        start = math.radians(given.hood_meets + given.hood_hit)
        self.hood_end = math.radians(given.hood_to)
        if not start < self.hood_end <= math.pi / 2:
            raise ValueError(f"--hood-to: {given.hood_to:g} degrees; more than --hood-meets and "
                             f"--hood-hit together, {math.degrees(start):g}, at most 90")
        self.warnings = []
        self.check_stream()
        self.check_hood(meets, start)
        self.at_hood = meets.beside(meets.thickness / 2)
        on = meets.hit(start, given.friction)
        off = on.turn(given.hood_radius / 1000 - on.thickness / 2, self.hood_end, given.friction, True)
        self.hood_start = start
        # Along the plate, not along the middle of the stream: the plate's own arc has its place.
        end = arc(self.at_hood, given.hood_radius / 1000, start, self.hood_end)[-1]
        off.x = end[0] - off.thickness / 2 * math.sin(off.angle)
        off.z = end[1] - off.thickness / 2 * math.cos(off.angle)
        low, high = 0.0, off.z - given.lip / 1000
        if high <= 0:
            raise ValueError(f"--lip: {given.lip:g} mm; the hood ends at {1000 * off.z:.0f} mm, and the lip has to be below that by "
                             "the arc of the spoon and some room")
        for _ in range(60):  # the drop with which the spoon's lip has its height
            drop = (low + high) / 2
            if self.spoon(off, drop)[-1][1] > given.lip / 1000:
                low = drop
            else:
                high = drop
        self.plate = self.spoon(off, drop)
        if drop < 0.02:
            raise ValueError("the spoon leaves no room below the hood; lower --lip, --spoon-radius or "
                             "--hood-radius")
        highest = 1000 * self.room_above(on, end)
        if given.spoon_up > highest:
            raise ValueError(f"--spoon-up: {given.spoon_up:g} mm; at most {highest:.0f} mm: a longer upright part would stand in the "
                             "stream on the hood")
        falls = off.drop(drop)
        turned = falls.angle - self.spoon_hit()
        if turned <= math.radians(given.spoon_to):
            raise ValueError(f"--spoon-to: {given.spoon_to:g} degrees; the stream has "
                             f"{math.degrees(turned):.1f} where it meets the spoon: less, or a smaller "
                             "--spoon-behind")
        onto = falls.hit(turned, given.friction)
        lip = onto.turn(given.spoon_radius / 1000 - onto.thickness / 2,
                        math.radians(given.spoon_to), given.friction, False)
        lip.x, lip.z = self.plate[-1][0] + lip.thickness / 2 * math.sin(lip.angle), \
            self.plate[-1][1] + lip.thickness / 2 * math.cos(lip.angle)
        if given.receiving >= given.lip:
            raise ValueError(f"--receiving: {given.receiving:g} mm must be below --lip, {given.lip:g} mm")
        self.stations = [("leaves the belt", leaves), ("meets the hood", meets), ("on the hood", on),
                         ("leaves the hood", off), ("meets the spoon", falls), ("on the spoon", onto),
                         ("leaves the spoon", lip),
                         ("meets its belt", lip.drop(lip.z - given.receiving / 1000))]
        self.mass = given.flow / 3.6 * (self.time(on, off) + self.time(off, falls) + self.time(onto, lip))

    def check_stream(self):
        """Whether the stream is as thick as the flow makes it."""
        given = self.given
        made = given.flow / 3.6 / (given.speed * given.stream_width / 1000 * given.bulk_density) * 1000
        layer = max(made, GRAIN)
        if not layer / FAR <= given.stream <= layer * FAR:
            self.warnings.append(
                f"--stream {given.stream:g} mm: {given.flow:g} t/h at {given.speed:g} m/s, {given.stream_width:g} mm wide "
                f"and of {given.bulk_density:g} kg/m3, are {made:.2g} mm thick, "
                f"and no layer is thinner than a grain, {GRAIN:g} mm; the chute is laid out for another stream: change --stream, --flow, "
                "--stream-width or --bulk-density")

    def check_hood(self, meets, start):
        """Whether the hood behind the place of impact takes up the whole thickness of the stream."""
        given = self.given
        hit = math.radians(given.hood_hit)
        needed = math.acos(max(-1.0, math.cos(hit) - 1000 * meets.thickness / given.hood_radius)) - hit
        factor = ENOUGH_THIN if given.stream < THIN else ENOUGH
        ends, least, enough = (f"{math.degrees(angle):.3g}" for angle in
                               (self.hood_end - start, start + needed, start + factor * needed))
        if start + needed > math.pi / 2:
            raise ValueError(f"--stream: a stream of {1000 * meets.thickness:.3g} mm is too thick for the hood: its "
                             f"lower side meets no arc of --hood-radius {given.hood_radius:g} before 90 degrees; a larger "
                             "--hood-radius or --hood-hit, or less --stream")
        if self.hood_end < start + needed:
            raise ValueError(f"--hood-to: {given.hood_to:g} degrees; the hood ends {ends} degrees behind the place where the "
                             f"upper side of the stream meets it, the lower side meets it {math.degrees(needed):.3g} degrees "
                             f"behind and would pass below its edge. At least {least}, better {enough}")
        if self.hood_end < start + factor * needed:
            self.warnings.append(
                f"--hood-to {given.hood_to:g}: the hood is {(self.hood_end - start) / needed:.2g} times as long as it takes to "
                "meet the whole stream. Simulated with a stream of 6 mm, hoods of 1.6 and 3.6 times missed: dry ore left the "
                "spoon at 53 and 43 degrees, laid out were 30; one of 6.6 times did what it was laid out for, and with a "
                f"stream of 25 mm one of 3.5 times: at least {enough} degrees")

    def room_above(self, on, end):
        """Length of the spoon's upright part with which it reaches the stream on the hood, as thick as where it meets it [m]."""
        radius, start = self.given.hood_radius / 1000, self.hood_start
        centre = (self.at_hood[0] - radius * math.sin(start), self.at_hood[1] - radius * math.cos(start))
        along = (-math.cos(self.spoon_start), math.sin(self.spoon_start))
        arm = (self.plate[0][0] - centre[0], self.plate[0][1] - centre[1])
        middle = arm[0] * along[0] + arm[1] * along[1]
        square = middle**2 + (radius - on.thickness)**2 - arm[0]**2 - arm[1]**2
        if square <= 0 or math.sqrt(square) <= middle:  # it passes beside the hood: up to the hood's edge
            return (end[1] - self.plate[0][1]) / math.sin(self.spoon_start)
        return math.sqrt(square) - middle

    @staticmethod
    def time(a, b):
        """Between two stations, at the mean of their speeds [s]."""
        return math.dist((a.x, a.z), (b.x, b.z)) / ((a.speed + b.speed) / 2)

    def spoon_hit(self):
        """Angle between stream and spoon where they meet: the arc turns away from its upright part."""
        return math.acos(1 - self.given.spoon_behind / self.given.spoon_radius)

    def spoon(self, off, drop):
        """Points of the arc of a spoon that the stream meets after a drop."""
        falls = off.drop(drop)
        radius = self.given.spoon_radius / 1000
        back = self.spoon_hit()
        behind = falls.beside(-self.given.spoon_behind / 1000)
        begin = (behind[0] - radius * math.sin(back) * math.cos(falls.angle),
                 behind[1] + radius * math.sin(back) * math.sin(falls.angle))
        self.spoon_start = falls.angle
        return arc(begin, radius, falls.angle, math.radians(self.given.spoon_to))

    def print(self):
        print(f"{'stream':18}{'x [mm]':>8}{'z [mm]':>8}{'angle [deg]':>13}{'speed [m/s]':>13}"
              f"{'thick [mm]':>12}")
        for name, at in self.stations:
            print(f"{name:18}{1000 * at.x:8.0f}{1000 * at.z:8.0f}{math.degrees(at.angle):13.1f}"
                  f"{at.speed:13.2f}{1000 * at.thickness:12.1f}")
        last = self.stations[-1][1]
        print(f"along the receiving belt {last.speed * math.cos(last.angle):.2f} m/s, into it "
              f"{last.speed * math.sin(last.angle):.2f} m/s; {self.mass:.3g} kg between hood and lip")


def arc(begin, radius, start, end):
    """Points of a plate that begins somewhere at an angle and turns to another, steeper or flatter."""
    steps = max(1, math.ceil(math.degrees(abs(end - start)) / SEGMENT))
    side = 1 if end > start else -1
    points = []
    for k in range(steps + 1):
        a = start + (end - start) * k / steps
        points.append((begin[0] + side * radius * (math.sin(a) - math.sin(start)),
                       begin[1] + side * radius * (math.cos(a) - math.cos(start))))
    return points


def before(point, angle, length):
    """A place that a plate at an angle has a length before one."""
    return (point[0] - length * math.cos(angle), point[1] + length * math.sin(angle))
