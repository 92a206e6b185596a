nValue = {}
for r = 1, 600 do
  nRound = r
  for i = 0, 39 do
    nI = i
    nValue[nI] = (nI * 17 + nRound) % 41
  end
  for i = 0, 38 do
    nI = i
    for j = 0, 38 - nI do
      nJ = j
      if nValue[nJ] > nValue[nJ + 1] then
        nSwap = nValue[nJ]
        nValue[nJ] = nValue[nJ + 1]
        nValue[nJ + 1] = nSwap
      end
    end
  end
end
print(nValue[39])
