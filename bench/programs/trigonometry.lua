-- Sine, cosine and square root in a loop.
local n = tonumber(arg[1] or 5000000)
local sin, cos, sqrt, degree = math.sin, math.cos, math.sqrt, math.pi / 180
local sum = 0.0
for i = 0, n - 1 do
    local a = i * 0.37
    sum = sum + sin(a * degree) * cos(0.5 * a * degree) + sqrt(i + 1.0)
end
print(string.format("%.3f", sum))
