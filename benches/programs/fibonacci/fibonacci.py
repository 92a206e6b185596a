def fibonacci(n):
    if n < 2:
        return n
    a = fibonacci(n - 1)
    b = fibonacci(n - 2)
    return a + b


print(fibonacci(35))
