# A transformation is six numbers: a place, and angles in degrees about x, then y, then z of the turned frame.
from math import atan2, cos, degrees, radians, sin, sqrt


def rotation(t):
    a, b, c = radians(t[3]), radians(t[4]), radians(t[5])
    sa, ca, sb, cb, sc, cc = sin(a), cos(a), sin(b), cos(b), sin(c), cos(c)
    return (
        cb * cc, -cb * sc, sb,
        ca * sc + sa * sb * cc, ca * cc - sa * sb * sc, -sa * cb,
        sa * sc - ca * sb * cc, sa * cc + ca * sb * sc, ca * cb,
    )


def product(left, right):
    a, b, c, d, e, f, g, h, i = rotation(left)
    j, k, m, n, o, p, q, s, t = rotation(right)
    r00, r01, r02 = a * j + b * n + c * q, a * k + b * o + c * s, a * m + b * p + c * t
    r12 = d * m + e * p + f * t
    r22 = g * m + h * p + i * t
    x, y, z = right[:3]
    return (
        left[0] + a * x + b * y + c * z,
        left[1] + d * x + e * y + f * z,
        left[2] + g * x + h * y + i * z,
        degrees(atan2(-r12, r22)),
        degrees(atan2(r02, sqrt(r00 * r00 + r01 * r01))),
        degrees(atan2(-r01, r00)),
    )


def main():
    place, step = (0, 0, 0, 0, 0, 0), (1, 2, 3, 10, 20, 30)
    for _ in range(500000):
        place = product(place, step)
    print(f"{place[0]:.3f} {place[5]:.3f}")


main()
