from math import cos, floor, radians, sqrt


def main():
    total = 0
    for i in range(1, 4000001):
        x = sqrt(i) * max(i % 3, 1)
        total += abs(floor(x) - i / 2) + cos(radians(i))
    print(round(total))


main()
