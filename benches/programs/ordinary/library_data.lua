tray = { nSlot = {}, nUsed = 0 }
for i = 0, 7 do tray.nSlot[i] = 0 end
nSum = 0
for i = 1, 1000000 do
  nI = i
  tray.nSlot[nI % 8] = nI
  tray.nUsed = tray.nUsed + 1
  nSum = nSum + tray.nSlot[3]
end
print(nSum)
