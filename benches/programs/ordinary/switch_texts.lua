sCommand = "idle"
nDone = 0
for i = 1, 1500000 do
  nI = i
  if sCommand == "idle" then
    sCommand = "approach"
  elseif sCommand == "approach" then
    sCommand = "close gripper"
  elseif sCommand == "close gripper" then
    sCommand = "depart"
    nDone = nDone + 1
  elseif sCommand == "depart" then
    sCommand = "place"
  else
    sCommand = "idle"
  end
end
print(nDone)
