nGrid = {}
for i = 0, 9 do
  nGrid[i] = {}
  for j = 0, 11 do nGrid[i][j] = 0 end
end
nSum = 0
for r = 1, 8000 do
  nRound = r
  for i = 0, 9 do
    nI = i
    for j = 0, 11 do
      nJ = j
      nGrid[nI][nJ] = nGrid[nI][nJ] + 1
      nSum = nSum + nGrid[nI][nJ] % 2
    end
  end
end
print(nSum)
