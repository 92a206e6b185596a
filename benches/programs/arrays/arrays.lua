local a, b, c = {}, {}, {}
for i = 0, 299 do
  a[i], b[i], c[i] = {}, {}, {}
  for j = 0, 299 do
    a[i][j] = i + j
    b[i][j] = i - 2 * j
  end
end
for i = 0, 299 do
  for j = 0, 299 do
    local sum = 0
    for k = 0, 299 do
      sum = sum + a[i][k] * b[k][j]
    end
    c[i][j] = sum
  end
end
local trace = 0
for i = 0, 299 do
  trace = trace + c[i][i]
end
print(trace)
