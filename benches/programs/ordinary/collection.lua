nStock = { bolt = 0, nut = 0, gear = 0, plate = 0, spring = 0 }
for i = 1, 700000 do
  nI = i
  nStock["bolt"] = nStock["bolt"] + 1
  nStock["plate"] = nStock["plate"] + nStock["bolt"] % 3
end
print(nStock["plate"])
