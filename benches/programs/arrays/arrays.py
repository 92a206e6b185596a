def main():
    a = [[0] * 200 for _ in range(200)]
    b = [[0] * 200 for _ in range(200)]
    c = [[0] * 200 for _ in range(200)]
    for i in range(200):
        for j in range(200):
            a[i][j] = i + j
            b[i][j] = i - 2 * j
    for i in range(200):
        for j in range(200):
            total = 0
            for k in range(200):
                total = total + a[i][k] * b[k][j]
            c[i][j] = total
    trace = 0
    for i in range(200):
        trace = trace + c[i][i]
    print(trace)


main()
