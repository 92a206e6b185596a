sLast = ""
nAlarms = 0
function report(text, level)
  if level >= 3 then
    sLast = text
    nAlarms = nAlarms + 1
  end
end
for i = 1, 1000000 do
  nI = i
  report("air pressure is low", nI % 5)
end
print(nAlarms)
