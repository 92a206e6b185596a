local function fibonacci(n)
  if n < 2 then
    return n
  end
  local a = fibonacci(n - 1)
  local b = fibonacci(n - 2)
  return a + b
end

print(fibonacci(35))
