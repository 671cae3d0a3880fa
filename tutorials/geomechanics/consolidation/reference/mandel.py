"""Coefficients of Mandel's series (1953) for system/controlDict: the pore pressure of a slab of half-width a between smooth, rigid plates that a force F pushes together, drained at x = +-a.

    p = (F/a) sum_k c_k (cos(A_k x/a) - cos A_k) exp(-A_k^2 T),    T = c_v t/a^2,    tan A_k = A_k (1 - nu)/(nu_u - nu),
    c_k = (2/3) B (1 + nu_u) sin A_k/(A_k - sin A_k cos A_k),    B = M/(K + M),    K_u = K + M,    1/c_v = (gamma_w/k)(1/M + 1/E_oed),    M = K_w/n

M [Pa] the stiffness of the water in its pores, K, G, E_oed [Pa] of the grains. Prints c_v, A_k, c_k and where the pressure in the middle is largest.
"""
import math

E, nu, n, K_w, k, gamma_w = 8.333333333333333e6, 0.25, 0.4, 2.2e9, 7e-5, 9810
G, K, M = E / (2 * (1 + nu)), E / (3 * (1 - 2 * nu)), K_w / n
E_oed, K_u = K + 4 * G / 3, K + M
nu_u = (3 * K_u - 2 * G) / (2 * (3 * K_u + G))
B = M / K_u
c_v = k / gamma_w / (1 / M + 1 / E_oed)


def root(i):
    """The i-th root, i = 1, 2, .., between (i - 1) pi and (i - 1/2) pi, by bisection."""
    low, high = (i - 1) * math.pi + 1e-9, (i - 0.5) * math.pi - 1e-12
    f = lambda A: math.sin(A) - A * (1 - nu) / (nu_u - nu) * math.cos(A)
    for _ in range(200):
        middle = (low + high) / 2
        low, high = (middle, high) if f(low) * f(middle) > 0 else (low, middle)
    return low


A = [root(i) for i in range(1, 13)]
c = [2 / 3 * B * (1 + nu_u) * math.sin(a) / (a - math.sin(a) * math.cos(a)) for a in A]
p = lambda x, T: sum(ck * (math.cos(a * x) - math.cos(a)) * math.exp(-a * a * T) for a, ck in zip(A, c))

if __name__ == "__main__":
    print(f"nu_u {nu_u:.9g}, B {B:.9g}, c_v {c_v:.9g} m^2/s, p(0, 0+) {B * (1 + nu_u) / 3:.9g} F/a")
    for a, ck in zip(A, c):
        print(f"A {a:.12g} c {ck:.12g}")
    T = max((i * 1e-5 for i in range(5000, 10000)), key=lambda T: p(0, T))
    print(f"largest {p(0, T):.9g} F/a = {p(0, T) / (B * (1 + nu_u) / 3):.9g} of the first at T = {T:.5f}")
    print(" + ".join(f"{ck:.10g}*(cos({a:.12g}*$x) - {math.cos(a):.10g})*exp(-{a * a * c_v:.10g}*$t)" for a, ck in list(zip(A, c))[:6]))
