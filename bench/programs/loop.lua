-- Whole and real arithmetic with a decision in a loop.
local n = tonumber(arg[1] or 10000000)
local k, sum = 1, 0.0
for i = 0, n - 1 do
    k = (k * 31 + i) % 65537
    if k % 3 == 0 then sum = sum + k * 0.5
    else sum = sum - i * 0.25 end
end
print(string.format("%.3f", sum))
