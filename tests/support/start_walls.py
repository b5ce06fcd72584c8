"""The walls of random cases (starts.py): their shapes, motions and loads."""

from start_numbers import about, often, si, vector


class Walls:
    """The walls of one random case, about grains in a box from (0, 0, bottom) with a square
    base of `side` and a height; `dice` are its random numbers, `case` is its tree."""

    def add_walls(self):
        dice = self.dice
        walls = {}
        if often(dice, 0.6):
            level = dice.choice((0.0, 0.0, -self.radius, self.bottom + 0.3 * self.radius))
            walls["floor"] = {"material": "side", "shapes": [
                {"plane": {"point": vector((0, 0, level), "m"), "normal": [0, 0, 1]}}]}
        if often(dice, 0.2):
            radius = self.side * dice.choice((0.3, 0.71, 0.8))
            walls["shell"] = {"material": "side", "shapes": [{"cylinder": {
                "foot": vector((self.side / 2, self.side / 2, self.bottom), "m"),
                "radius": si(radius, "m"), "length": si(3 * self.height, "m")}}]}
        if often(dice, 0.2):
            walls["lid"] = {"material": "side", "shapes": [{"plane": {
                "point": vector((0, 0, self.bottom + 1.2 * self.height), "m"),
                "normal": [0, 0, -1]}}],
                "load": {"stress": si(about(dice, 1e2, 1e6), "Pa"),
                         "area": si(self.side ** 2, "m2"),
                         "mass": si(about(dice, 1e-6, 1.0), "kg"), "axis": [0, 0, -1]}}
        if often(dice, 0.3):
            walls["part"] = {"material": "side", "shapes": [
                self.part() for _ in range(dice.choice((1, 1, 2)))]}
        for wall in walls.values():
            self.add_motion(wall)
        if walls:
            self.case["walls"] = walls

    def inside(self, spread=1.0):
        """A point in the box of the grains, or as far beyond its middle as spread says."""
        middle = (self.side / 2, self.side / 2, self.bottom + self.height / 2)
        half = (self.side / 2, self.side / 2, self.height / 2)
        return [m + spread * h * self.dice.uniform(-1, 1) for m, h in zip(middle, half)]

    def direction(self):
        return self.dice.choice(([0, 0, 1], [0, 0, -1], [1, 0, 0], [0, 1, 0], [1, -2, 0.5]))

    def part(self):
        """A hopper about the grains, or a body between or below them."""
        dice = self.dice
        kind = dice.choice(("cone", "cone", "box", "bar", "disc", "annulus"))
        place = self.inside(1.5)
        if kind == "cone":
            top = self.side * dice.choice((0.3, 0.75, 1.5))
            foot = dice.choice((0.0, 0.2 * top, 0.5 * top, 1.4 * top))
            shape = {"foot": vector((self.side / 2, self.side / 2,
                                     self.bottom - dice.choice((0, 0.5)) * self.height), "m"),
                     "foot_radius": si(foot, "m"), "top_radius": si(top, "m"),
                     "length": si(2 * self.height, "m"),
                     "side": dice.choice(("inside", "inside", "outside"))}
        elif kind == "box":
            shape = {"center": vector(place, "m"),
                     "size": vector([self.side * about(dice, 0.01, 1.0) for _ in range(3)], "m")}
        elif kind == "bar":
            shape = {"from": vector(place, "m"), "to": vector(self.inside(1.5), "m"),
                     "width": si(self.radius * about(dice, 0.1, 3.0), "m"),
                     "height": si(self.radius * about(dice, 0.1, 3.0), "m")}
        elif kind == "disc":
            shape = {"center": vector(place, "m"), "normal": self.direction(),
                     "radius": si(self.side * about(dice, 0.05, 1.0), "m")}
        else:
            outer = self.side * about(dice, 0.05, 1.0)
            shape = {"center": vector(place, "m"), "normal": self.direction(),
                     "inner_radius": si(outer * dice.uniform(0.1, 0.9), "m"),
                     "outer_radius": si(outer, "m")}
        return {kind: shape}

    def add_motion(self, wall):
        """A wall that turns, swings, runs like a belt, or does several of these."""
        dice = self.dice
        swings = often(dice, 0.2)
        if often(dice, 0.2):
            wall["spin"] = si(about(dice, 1e-2, 1e4) * dice.choice((-1, 1)), "rad/s")
        if often(dice, 0.15):
            wall["surface_velocity"] = vector([about(dice, 1e-3, 100.0), 0, 0], "m/s")
        if swings:
            self.add_oscillation(wall)
        if ("spin" in wall or swings) and often(dice, 0.6):
            plane = "plane" in wall["shapes"][0]  # turns about its normal only
            wall["spin_axis"] = [0, 0, -1] if plane and often(dice, 0.8) else self.direction()
            wall["spin_point"] = vector(dice.choice((
                (self.side / 2, self.side / 2, self.bottom), self.inside())), "m")

    def add_oscillation(self, wall):
        dice = self.dice
        swing = {"frequency": si(about(dice, 1.0, 3e5), "Hz")}
        if often(dice, 0.7):
            swing["amplitude"] = si(self.radius * about(dice, 1e-4, 3.0), "m")
            swing["direction"] = [1, 0, 0] if "load" in wall else self.direction()
        if "amplitude" not in swing or often(dice, 0.3):
            swing["angle"] = si(about(dice, 1e-4, 6.0), "rad")
        if often(dice, 0.5):
            swing["phase"] = si(dice.uniform(-6.28, 6.28), "rad")
        wall["oscillation"] = swing

    def add_changes(self, stage):
        """What walls do in a stage."""
        dice = self.dice
        changes = {}
        if "floor" in self.case.get("walls", {}) and often(dice, 0.5):
            speed = about(dice, 1e-2, 300.0) * dice.choice((-1, 1))
            changes["floor"] = {"velocity": vector((0, 0, speed), "m/s")}
        if "part" in self.case.get("walls", {}) and often(dice, 0.5):
            changes["part"] = {"spin": si(about(dice, 1e-2, 1e4), "rad/s")}
        if "lid" in self.case.get("walls", {}) and often(dice, 0.5):
            changes["lid"] = {"stress": si(about(dice, 1e2, 1e8), "Pa")}
        if changes:
            stage["walls"] = changes
