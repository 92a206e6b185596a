local sum = 0
for i = 1, 6000 do
  local j = i
  while j >= 1 do
    if j % 3 == 0 then
      sum = sum + i * j
    else
      sum = sum - j / 2
    end
    j = j - 1
  end
end
print(math.tointeger(sum) or sum)
