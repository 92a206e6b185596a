function round(x)
  return math.floor(x + 0.5)
end
nSum = 0
for i = 1, 700000 do
  nI = i
  nX = math.sqrt(nI) * math.max(nI % 3, 1)
  nSum = nSum + math.abs(math.floor(nX) - nI / 2) + math.cos(math.rad(nI))
end
print(round(nSum / 1000))
