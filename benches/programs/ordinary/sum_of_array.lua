nValue = {}
for i = 1, 50 do
  nValue[i] = i - 1
end
t = { nResult = 0 }
function average(values, result)
  sum = 0
  for i = 1, #values do
    l_i = i
    sum = sum + values[l_i]
  end
  result.nResult = sum / #values
end
for r = 1, 40000 do
  nRound = r
  average(nValue, t)
end
print(t.nResult)
