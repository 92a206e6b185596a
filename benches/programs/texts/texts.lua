local text, length = "", 0
for i = 1, 2000000 do
  text = text .. "ab"
  text = text .. tostring(i)
  if #text > 100 then
    length = length + #text
    text = ""
  end
end
print(length)
