sField = {}
nSum = 0
for i = 1, 100000 do
  nI = i
  sLine = "12;gear;ok;340"
  nCount = 0
  nAt = string.find(sLine, ";", 1, true)
  while nAt do
    sField[nCount] = string.sub(sLine, 1, nAt - 1)
    nCount = nCount + 1
    sLine = string.sub(sLine, nAt + 1)
    nAt = string.find(sLine, ";", 1, true)
  end
  sField[nCount] = sLine
  nSum = nSum + nCount + string.len(sField[1])
end
print(nSum)
