local composite, primes = {}, 0
for _ = 1, 15 do
  for i = 2, 1000000 do
    composite[i] = false
  end
  primes = 0
  for i = 2, 1000000 do
    if not composite[i] then
      primes = primes + 1
      local j = i * i
      while j <= 1000000 do
        composite[j] = true
        j = j + i
      end
    end
  end
end
print(primes)
