def main():
    a = [[0] * 300 for _ in range(300)]
    b = [[0] * 300 for _ in range(300)]
    c = [[0] * 300 for _ in range(300)]
    for i in range(300):
        for j in range(300):
            a[i][j] = i + j
            b[i][j] = i - 2 * j
    for i in range(300):
        for j in range(300):
            total = 0
            for k in range(300):
                total = total + a[i][k] * b[k][j]
            c[i][j] = total
    trace = 0
    for i in range(300):
        trace = trace + c[i][i]
    print(trace)


main()
