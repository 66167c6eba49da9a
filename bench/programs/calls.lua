-- Calls: a recursion of about seven million of them.
local function fibonacci(n)
    if n < 2 then return n end
    return fibonacci(n - 1) + fibonacci(n - 2)
end
print(fibonacci(tonumber(arg[1] or 32)))
