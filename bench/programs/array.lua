-- Reading and writing elements of an array.
local rounds = tonumber(arg[1] or 10000)
local a = {}
for i = 0, 999 do a[i] = i % 7 end
for _ = 1, rounds do
    for i = 1, 998 do a[i] = 0.5 * a[i] + 0.25 * (a[i - 1] + a[i + 1]) end
end
print(string.format("%.3f", a[500]))
