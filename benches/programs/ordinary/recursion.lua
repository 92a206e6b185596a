function fibonacci(n, result)
  if n < 2 then
    result.value = n
  else
    local a, b = { value = 0 }, { value = 0 }
    fibonacci(n - 1, a)
    fibonacci(n - 2, b)
    result.value = a.value + b.value
  end
end
t = { value = 0 }
fibonacci(26, t)
print(t.value)
