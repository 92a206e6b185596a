def main():
    composite = [False] * 1000001
    for _ in range(15):
        for i in range(2, 1000001):
            composite[i] = False
        primes = 0
        for i in range(2, 1000001):
            if not composite[i]:
                primes = primes + 1
                j = i * i
                while j <= 1000000:
                    composite[j] = True
                    j = j + i
    print(primes)


main()
