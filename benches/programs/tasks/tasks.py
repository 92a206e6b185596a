# Generators that take turns of ten lines, as tasks of priority 10 do.
done = 0


def count(rounds):
    global done
    total = 0
    for i in range(1, rounds + 1):
        total = total + i
        if i % 5 == 0:
            yield
    done = done + 1


def main():
    tasks = [count(2000) for _ in range(1000)]
    while done < 1000:
        for task in tasks:
            next(task, None)
    print(done)


main()
