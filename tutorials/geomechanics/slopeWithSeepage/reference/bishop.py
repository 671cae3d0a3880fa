#!/usr/bin/env python3
"""Factors of safety of the slope by Bishop's simplified method (1955): slices of a circle, the least of a grid of circles, refined.

    F = sum_k [c b + (W + P - u b) tan(phi)]/m_k / (M/R),    m_k = cos(a) + sin(a) tan(phi)/F

W, P weights of a slice and of the water above it, b its width, a the inclination of its base, u the pore pressure there; M the moment of the weights and of the water's push on the slope about the centre of the circle, R its radius.

    reference/bishop.py
"""
import math

HEIGHT, REACH, BASE = 10, 20, -5  # [m] of the slope, along it, of the firm ground
COHESION, FRICTION, SOIL, WATER = 1e4, math.tan(math.radians(20)), 2e4, 1e4  # [Pa], [1], [N/m^3]
SLICES = 60


def ground(x):
    return min(HEIGHT, max(0.0, HEIGHT - x * HEIGHT / REACH))


def factor(x_c, y_c, radius, before, pore_pressure):
    """Of one circle, by the height of the water before the slope; none where it is no slip surface of it."""
    if y_c - radius < BASE:
        return None

    def depth(x):
        return y_c - math.sqrt(max(0.0, radius**2 - (x - x_c) ** 2))

    inside = [x for x in (x_c - radius + radius * i / 1000 for i in range(2001)) if depth(x) < ground(x) - 1e-9]
    if len(inside) < 20:
        return None
    width = (inside[-1] - inside[0]) / SLICES
    slices, moment = [], 0
    for k in range(SLICES):
        x = inside[0] + (k + 0.5) * width
        bottom, top = depth(x), ground(x)
        pond = WATER * max(0.0, before - top)
        weight = (SOIL * (top - bottom) + pond) * width
        moment += weight * (x_c - x) - pond * (ground(x - width / 2) - ground(x + width / 2)) * (y_c - top)
        slices.append((weight - pore_pressure(x, bottom) * width, math.asin((x_c - x) / radius)))
    if moment <= 0:
        return None
    guess = 1.5
    for _ in range(60):
        shares = [math.cos(a) + math.sin(a) * FRICTION / guess for _, a in slices]
        if min(shares) < 0.2:
            return None
        guess = sum((COHESION * width + effective * FRICTION) / m for (effective, _), m in zip(slices, shares)) * radius / moment
    return guess


def least(before, pore_pressure):
    circles = [(x, y, y - bottom / 2) for x in range(5, 27) for y in (11 + 1.5 * i for i in range(22)) for bottom in range(-10, 3)]
    best, circle = min((f, c) for c in circles if (f := factor(*c, before, pore_pressure)))
    step = 0.5
    while step > 0.02:
        for way in [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1), (0, 1, 1), (0, -1, -1)]:
            near = tuple(q + step * d for q, d in zip(circle, way))
            found = factor(*near, before, pore_pressure)
            if found and found < best:
                best, circle = found, near
                break
        else:
            step /= 2
    return best


if __name__ == "__main__":
    print(f"dry: {least(-100, lambda x, y: 0):.3f}")
    for level in [0, 3, 6, 8, 10]:
        print(f"water at {level} m, within the slope, too: {least(level, lambda x, y: WATER * max(0, level - y)):.3f}")
    print(f"water that has fallen from 10 m to 0, B = 1: {least(0, lambda x, y: WATER * (ground(x) - y)):.3f}")
