-- The blocks in Lua.
local blocks = tonumber(arg[1] or 1000000)
local format, cos, sin, pi = string.format, math.cos, math.sin, math.pi
local write = io.write

-- `12.5`: three decimals at most, no zeros behind the last digit that counts.
local function number(value)
    local text = format("%.3f", value):gsub("%.?0+$", "")
    if text == "-0" then return "0" end
    return text
end

io.stdout:setvbuf("full", 65536)
write("N10 G90\n")
for i = 0, blocks - 1 do
    local angle = i * 0.37 * (pi / 180)
    local motion = i == 0 and " G1" or ""
    write("N", 10 * (i + 2), motion, " X", number(100 * cos(angle)), " Y",
          number(100 * sin(angle)), " Z", number(i * 0.001), "\n")
end
