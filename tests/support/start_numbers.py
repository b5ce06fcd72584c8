"""Numbers of random cases, and how they are written with a unit."""

import math


def si(value, unit):
    return f"{value:.8g} {unit}"


def vector(values, unit):
    return [si(value, unit) for value in values]


def about(dice, low, high):
    """Uniform in the logarithm."""
    return math.exp(dice.uniform(math.log(low), math.log(high)))


def often(dice, probability):
    return dice.random() < probability
