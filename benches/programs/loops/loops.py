def main():
    total = 0
    for i in range(1, 6001):
        j = i
        while j >= 1:
            if j % 3 == 0:
                total += i * j
            else:
                total -= j / 2
            j -= 1
    print(int(total))


main()
