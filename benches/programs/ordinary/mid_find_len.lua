sLine = "part=gear;count=12;state=ok"
nSum = 0
for i = 1, 500000 do
  nI = i
  nAt = string.find(sLine, "=", 1, true) - 1
  sKey = string.sub(sLine, 1, nAt)
  nSum = nSum + string.len(sKey) + string.find(sLine, "state", 1, true) - 1
end
print(nSum)
