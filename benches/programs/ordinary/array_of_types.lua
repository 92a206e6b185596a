tPart = {}
for i = 0, 19 do
  tPart[i] = { nWeight = 0, bGood = false, sName = "" }
end
nSum = 0
for r = 1, 50000 do
  nRound = r
  for i = 0, 19 do
    nI = i
    tPart[nI].nWeight = nI + nRound
    if tPart[nI].bGood == false then
      nSum = nSum + tPart[nI].nWeight
    end
  end
end
print(nSum)
