tStation = { nCount = 0, nMax = 10, nRounds = 0, bBusy = false }
for i = 1, 1000000 do
  nI = i
  tStation.nCount = tStation.nCount + 1
  if tStation.nCount >= tStation.nMax then
    tStation.nRounds = tStation.nRounds + 1
    tStation.nCount = 0
  end
  tStation.bBusy = not tStation.bBusy
end
print(tStation.nRounds)
