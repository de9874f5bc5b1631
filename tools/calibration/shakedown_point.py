#!/usr/bin/env python3
"""Shakedown limit p0/k of a circular Hertzian contact in full slip, below the surface, for wrc_shakedown_limit's point form.

    shakedown_point.py        prints mu, p0/k, the library's fit and the depth; 20 s

For a material that hardens kinematically the load shakes down if at every place (y, z) a fixed back stress keeps the whole
path of the deviatoric stress, as the load rolls by along x, within the yield surface: p0/k = 1 / (largest over the places
of the radius of the smallest ball about the path, norm sqrt(J2), at p0 = 1). Stresses from the point forces of Boussinesq
and Cerruti (Johnson 1985, 3.19 and 3.76), integrated over the circle; places in the plane y = 0, where the path is longest.
nu = 0.3. At mu = 0 the literature has 4.7. Beyond mu = 0.22 the surface comes first, 1 / mu.
"""
import numpy as np

NU = 0.3


def stresses(x, z, radii=120, angles=240):
    """(normal, tangential) stress, each [6, points] xx, yy, zz, xy, yz, zx at (x, 0, z), radius 1, p0 = 1, traction = p."""
    node, weight = np.polynomial.legendre.leggauss(radii)
    t = 0.25 * np.pi * (node + 1.0)  # r = sin t: smooth pressure
    angle = (np.arange(angles) + 0.5) * 2.0 * np.pi / angles
    r, c = np.sin(t)[:, None], np.cos(t)[:, None]
    force = (weight[:, None] * 0.25 * np.pi * c * c * r * (2.0 * np.pi / angles) * np.ones_like(angle)).ravel()
    px, py = (r * np.cos(angle)).ravel(), (r * np.sin(angle)).ravel()
    normal, tangential = np.zeros((6, x.size)), np.zeros((6, x.size))
    m = 1.0 - 2.0 * NU
    for i in range(x.size):
        X, Y, Z = x[i] - px, -py, z[i]
        r2 = X * X + Y * Y
        R = np.sqrt(r2 + Z * Z)
        a = m / (R * (R + Z))  # (1 - 2 nu)/r^2 (1 - z/R)
        xr, yr = X * X / r2, Y * Y / r2
        xy = X * Y / r2
        b = m * Z / R**3
        n5 = 3.0 / R**5
        normal[:, i] = [(force * k).sum() for k in (
            a * (xr - yr) + b * yr - n5 * Z * X * X,
            a * (yr - xr) + b * xr - n5 * Z * Y * Y,
            -n5 * Z**3,
            2.0 * a * xy - b * xy - n5 * X * Y * Z,
            -n5 * Y * Z * Z,
            -n5 * X * Z * Z)]
        s = R + Z
        tangential[:, i] = [(force * k).sum() for k in (
            -n5 * X**3 + m * (X / R**3 - 3 * X / (R * s**2) + X**3 / (R**3 * s**2) + 2 * X**3 / (R**2 * s**3)),
            -n5 * X * Y * Y + m * (X / R**3 - X / (R * s**2) + X * Y * Y / (R**3 * s**2) + 2 * X * Y * Y / (R**2 * s**3)),
            -n5 * X * Z * Z,
            -n5 * X * X * Y + m * (-Y / (R * s**2) + X * X * Y / (R**3 * s**2) + 2 * X * X * Y / (R**2 * s**3)),
            -n5 * X * Y * Z,
            -n5 * X * X * Z)]
    return normal / (2.0 * np.pi), tangential / (2.0 * np.pi)


def path(stress):
    """The deviator in coordinates whose length is sqrt(J2)."""
    mean = stress[:3].mean(axis=0)
    s = stress.copy()
    s[:3] -= mean
    return np.vstack([s[:3] / np.sqrt(2.0), s[3:]]).T


def ball(points, steps=3000):
    """Radius of the smallest ball (Badoiu, Clarkson), to 3e-4."""
    centre = points.mean(axis=0)
    for k in range(1, steps):
        far = np.argmax(((points - centre) ** 2).sum(axis=1))
        centre = centre + (points[far] - centre) / (k + 1.0)
    return np.sqrt(((points - centre) ** 2).sum(axis=1).max())


def main():
    depths = np.arange(0.10, 0.80, 0.04)
    x = np.concatenate([np.arange(-8, -2, 0.5), np.arange(-2, 2, 0.05), np.arange(2, 8.5, 0.5)])
    fields = [stresses(x, np.full(x.size, z)) for z in depths]
    for mu in np.arange(0.0, 0.26, 0.05):
        radius = [ball(path(n + mu * t)) for n, t in fields]
        worst = int(np.argmax(radius))
        fit = 1.0 / (0.2139 + 0.1 * mu**2 + 0.25 * mu**4)
        print(f"mu {mu:.2f}   p0/k {1.0 / radius[worst]:.3f}   fit {fit:.3f}   at depth {depths[worst]:.2f} a")


if __name__ == "__main__":
    main()
