nResult = 0
function limit(value, low, high)
  nResult = value
  if value < low then
    nResult = low
  elseif value > high then
    nResult = high
  end
end
nSum = 0
for i = 1, 1000000 do
  nI = i
  limit(nI % 100, 20, 80)
  nSum = nSum + nResult
end
print(nSum)
