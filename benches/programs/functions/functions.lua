local sqrt, max, abs, floor, cos, rad = math.sqrt, math.max, math.abs, math.floor, math.cos, math.rad
local sum = 0
for i = 1, 4000000 do
  local x = sqrt(i) * max(i % 3, 1)
  sum = sum + abs(floor(x) - i / 2) + cos(rad(i))
end
print(math.floor(sum + 0.5))
